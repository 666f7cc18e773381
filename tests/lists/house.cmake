# The house: its own checks, checked; each public header compiled alone; the commands of the documents, run.

find_program(LUXEL_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH REQUIRED)
foreach(check check_layers check_docs_commands count_tests)
  add_test(NAME "house: ${check} finds what is planted"
           COMMAND ${LUXEL_PYTHON} -B ${CMAKE_CURRENT_LIST_DIR}/../house/${check}_test.py)
endforeach()
add_test(NAME "house: the benchmark's charts say what was measured"
         COMMAND ${LUXEL_PYTHON} -B ${CMAKE_CURRENT_LIST_DIR}/../house/draw_charts_test.py)

add_test(NAME "house: every picture of the documents is committed or made by ./dev docs"
         COMMAND ${LUXEL_PYTHON} -B ${CMAKE_CURRENT_LIST_DIR}/../house/figures_test.py)

# One source file a header with nothing before it, compiled with the outside libraries of its own room: a header that
# leans on what others include, or lets another room's library through, fails. The programs may include everything. Of a
# header with a source file of its own the build does this: check_layers.py sees that it comes first there.
function(luxel_headers_alone room)
  file(GLOB headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/src/luxel/${room}/*.h)
  foreach(header ${headers})
    string(REGEX REPLACE "h$" "cpp" source ${header})
    if(EXISTS ${PROJECT_SOURCE_DIR}/src/${source})
      list(REMOVE_ITEM headers ${header})
    endif()
  endforeach()
  if(headers)
    foreach(header ${headers})
      file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/headers/${header}.cpp CONTENT "#include \"${header}\"\n")
    endforeach()
    list(TRANSFORM headers REPLACE "(.+)" "${PROJECT_BINARY_DIR}/headers/\\1.cpp")
    add_library(luxel_${room}_headers OBJECT EXCLUDE_FROM_ALL ${headers})
    target_link_libraries(luxel_${room}_headers PRIVATE luxel_flags fmt::fmt glm::glm ${ARGN})
    add_dependencies(luxel_headers luxel_${room}_headers)
  endif()
endfunction()

# A sanitizer build would only say again what the plain one says.
if(NOT LUXEL_SANITIZE)
  add_custom_target(luxel_headers)
  get_property(rooms GLOBAL PROPERTY LUXEL_ROOMS)
  foreach(room ${rooms})
    get_property(libraries GLOBAL PROPERTY LUXEL_LIBRARIES_OF_${room})
    luxel_headers_alone(${room} ${libraries})
  endforeach()
  luxel_headers_alone(apps CLI11::CLI11 nlohmann_json::nlohmann_json)
  target_compile_definitions(luxel_apps_headers PRIVATE $<TARGET_PROPERTY:luxel,COMPILE_DEFINITIONS>)
  add_test(NAME "house: every header without a source file compiles alone"
           COMMAND ${CMAKE_COMMAND} --build ${PROJECT_BINARY_DIR} --target luxel_headers)

  add_test(NAME "house: an outside project finds an installed Luxel and builds the README's program"
           COMMAND ${LUXEL_PYTHON} -B ${CMAKE_CURRENT_LIST_DIR}/../house/outside_project_test.py ${PROJECT_SOURCE_DIR}
                   ${PROJECT_BINARY_DIR})
  add_test(NAME "docs: every command in the documents runs"
           COMMAND ${LUXEL_PYTHON} -B ${PROJECT_SOURCE_DIR}/tools/check_docs_commands.py ${PROJECT_SOURCE_DIR}
                   ${CMAKE_RUNTIME_OUTPUT_DIRECTORY})
  set_tests_properties("house: every header without a source file compiles alone" "docs: every command in the documents runs"
                       PROPERTIES TIMEOUT 1200 COST 1000)
endif()
