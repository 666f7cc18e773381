# The house: its own checks, checked; each public header compiled alone; the commands of the documents, run.

find_program(LUXEL_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH REQUIRED)
foreach(check check_layers check_docs_commands count_tests)
  add_test(NAME "house: ${check} finds what is planted"
           COMMAND ${LUXEL_PYTHON} -B ${CMAKE_CURRENT_LIST_DIR}/../house/${check}_test.py)
endforeach()

# One source file a header, with nothing before it, and no include path but those of fmt and glm: a header that leans on
# what others include, or lets a heavy library through, fails. A sanitizer build would only say it again.
if(NOT LUXEL_SANITIZE)
  file(GLOB headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/src/luxel/*/*.h)
  set(alone)
  foreach(header ${headers})
    file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/headers/${header}.cpp CONTENT "#include \"${header}\"\n")
    list(APPEND alone ${PROJECT_BINARY_DIR}/headers/${header}.cpp)
  endforeach()
  add_library(luxel_headers OBJECT EXCLUDE_FROM_ALL ${alone})
  target_link_libraries(luxel_headers PRIVATE luxel_flags fmt::fmt glm::glm)
  add_test(NAME "house: every header compiles alone"
           COMMAND ${CMAKE_COMMAND} --build ${PROJECT_BINARY_DIR} --target luxel_headers)

  add_test(NAME "docs: every command in the documents runs"
           COMMAND ${LUXEL_PYTHON} -B ${PROJECT_SOURCE_DIR}/tools/check_docs_commands.py ${PROJECT_SOURCE_DIR}
                   ${CMAKE_RUNTIME_OUTPUT_DIRECTORY})
  set_tests_properties("house: every header compiles alone" "docs: every command in the documents runs"
                       PROPERTIES TIMEOUT 1200 COST 1000)
endif()
