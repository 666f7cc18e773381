# The library: all modules but those of the command, as luxel::luxel, with the headers in include/. The target has the same
# name from add_subdirectory, FetchContent and find_package.

# The version stands in two places: here it is seen to be one.
file(STRINGS ${PROJECT_SOURCE_DIR}/include/luxel/version.h version_lines REGEX "^#define LUXEL_VERSION_[A-Z]+ [0-9]+$")
list(TRANSFORM version_lines REPLACE "^.* " "")
list(JOIN version_lines "." version_of_header)
if(NOT version_of_header STREQUAL PROJECT_VERSION)
  message(FATAL_ERROR "include/luxel/version.h is of version ${version_of_header}, the project of ${PROJECT_VERSION}")
endif()

# Modules of programs alone, so that users of the library need neither a display nor options as text.
set(LUXEL_PROGRAM_MODULES viewer runs)
# Libraries that are headers alone: built in, and not linked by users.
set(LUXEL_HEADER_LIBRARIES nlohmann_json::nlohmann_json)

add_library(luxel_library STATIC)
add_library(luxel::luxel ALIAS luxel_library)
set_target_properties(luxel_library PROPERTIES OUTPUT_NAME luxel EXPORT_NAME luxel LINKER_LANGUAGE CXX
                                               VERIFY_INTERFACE_HEADER_SETS ON CXX_EXTENSIONS OFF)
target_compile_features(luxel_library PUBLIC cxx_std_20)
# What public headers include is a requirement; what only the objects call is linked.
target_link_libraries(luxel_library PUBLIC glm::glm PRIVATE fmt::fmt Threads::Threads)
# Instrumented objects need their runtime in every program.
if(LUXEL_SANITIZE)
  target_link_options(luxel_library PUBLIC -fsanitize=${LUXEL_SANITIZE})
endif()
if(LUXEL_COVERAGE)
  target_link_options(luxel_library PUBLIC --coverage)
endif()
get_property(modules GLOBAL PROPERTY LUXEL_MODULES)
list(REMOVE_ITEM modules ${LUXEL_PROGRAM_MODULES})
foreach(module ${modules})
  get_target_property(type luxel_${module} TYPE)
  if(NOT type STREQUAL "INTERFACE_LIBRARY")
    target_sources(luxel_library PRIVATE $<TARGET_OBJECTS:luxel_${module}>)
  endif()
  get_property(libraries GLOBAL PROPERTY LUXEL_LIBRARIES_OF_${module})
  list(REMOVE_ITEM libraries ${LUXEL_HEADER_LIBRARIES})
  target_link_libraries(luxel_library PRIVATE ${libraries})
endforeach()
file(GLOB public_headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/include/luxel/*.h ${PROJECT_SOURCE_DIR}/include/luxel/*/*.h)
target_sources(luxel_library PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/include FILES ${public_headers})
