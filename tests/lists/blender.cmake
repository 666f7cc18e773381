# The add-on for Blender, in one without a window; skipped where there is none.
find_program(LUXEL_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH REQUIRED)
find_program(LUXEL_BLENDER blender PATHS /usr/bin NO_DEFAULT_PATH)
function(luxel_blender_test check name)
  add_test(NAME "blender: ${name}" COMMAND ${LUXEL_PYTHON} -B ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../blender/blender_test.py $<TARGET_FILE:luxel>
                                           "${LUXEL_BLENDER}" ${check})
  set_tests_properties("blender: ${name}" PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 600)
endfunction()
luxel_blender_test(file "Luxel reads the scene that the add-on writes, and its meshes take the light")
luxel_blender_test(lamps "each kind of lamp gives the light that Cycles gives it")
luxel_blender_test(use "layers, modifiers and shared meshes are minded, a bake is stopped, mistakes are sentences")
luxel_blender_test(window "a bake leaves Blender usable, is taken back, and is stopped by Esc")
luxel_blender_test(cornell_box "the Cornell box has Cycles' light in its vertex colours and on its lightmap")
luxel_blender_test(office "an office has Cycles' light in its vertex colours")
