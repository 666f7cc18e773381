# What Luxel writes for browsers, in a headless one; skipped where there is none.
function(luxel_web_test what name)
  add_test(NAME "web: ${name}" COMMAND ${LUXEL_PYTHON} -B ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../web/page_test.py $<TARGET_FILE:luxel>
                                       "${LUXEL_NODE}" ${what})
  set_tests_properties("web: ${name}" PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 600)
endfunction()
luxel_web_test(desk "the page does what is clicked at a desk")
luxel_web_test(phone "the page does what is tapped on a phone")
luxel_web_test(glb "a GLB for each program is valid, and three.js shows Luxel's picture")
