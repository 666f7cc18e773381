# What every target of the project is compiled with, and luxel_module(): one static library per module, so that a module
# links, and sees the headers of, only the outside libraries whose home it is.

include(${CMAKE_CURRENT_LIST_DIR}/luxel_outside_libraries.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/luxel_outside_targets.cmake)

# For every target of the project. -ffp-contract=off and no -march: the same source gives the same bits on every host.
add_library(luxel_flags INTERFACE)
target_compile_features(luxel_flags INTERFACE cxx_std_20)
target_compile_options(luxel_flags INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion
                                             $<$<BOOL:${LUXEL_WERROR}>:-Werror> -ffp-contract=off -fno-math-errno)
target_include_directories(luxel_flags INTERFACE ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src)
if(LUXEL_UNITY)  # across files, a local name shadows nothing, and a type in an anonymous namespace is local to its file
  target_compile_options(luxel_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
else()
  target_compile_options(luxel_flags INTERFACE -Wshadow)
endif()
if(LUXEL_SANITIZE)
  target_compile_options(luxel_flags INTERFACE -fsanitize=${LUXEL_SANITIZE} -fno-sanitize-recover=all
                                               -fno-omit-frame-pointer
                                               -Wno-maybe-uninitialized)  # gcc 12 reports std::optional falsely then
  target_link_options(luxel_flags INTERFACE -fsanitize=${LUXEL_SANITIZE})
endif()
if(LUXEL_SANITIZE MATCHES "thread")
  target_compile_definitions(luxel_flags INTERFACE LUXEL_PLAIN_THREADS)  # see src/luxel/core/thread_pool.h
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(luxel_flags INTERFACE -Wno-tsan)  # gcc: fences are not followed; the suppressions explain where
  endif()
endif()

if(LUXEL_COVERAGE)
  # Not -fprofile-update=atomic: loops would wait for their counters. Whether a line ran is right, how often is not.
  target_compile_options(luxel_flags INTERFACE --coverage)
  target_link_options(luxel_flags INTERFACE --coverage)
endif()

if(LUXEL_FUZZ)
  target_compile_options(luxel_flags INTERFACE -fsanitize=fuzzer-no-link,address,undefined
                                               -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
endif()

# luxel_compile_together(TARGET): with LUXEL_UNITY, files of the target that can stand in one translation unit are compiled
# as one, since most of their time goes into headers that they share. The sources say which can, so CMake runs again when
# one changes. A missing include may go unnoticed in such a build; ./dev matrix has one without.
function(luxel_compile_together target)
  if(NOT LUXEL_UNITY)
    return()
  endif()
  find_program(LUXEL_PYTHON3 python3 PATHS /usr/bin NO_DEFAULT_PATH)
  if(NOT LUXEL_PYTHON3)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  execute_process(COMMAND ${LUXEL_PYTHON3} -B ${PROJECT_SOURCE_DIR}/tools/compile_units.py 8 ${sources}
                  WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} OUTPUT_VARIABLE units OUTPUT_STRIP_TRAILING_WHITESPACE
                  COMMAND_ERROR_IS_FATAL ANY)
  string(REPLACE "\n" ";" units ${units})
  foreach(source unit IN ZIP_LISTS sources units)
    set_property(SOURCE ${source} PROPERTY UNITY_GROUP ${unit})
  endforeach()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${sources} ${PROJECT_SOURCE_DIR}/tools/compile_units.py)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()

# fmt formats text, glm gives the vectors in signatures, and core/json.h is JSON for all modules.
function(luxel_module name)
  cmake_parse_arguments(MODULE "" "" "DEPENDS;LIBRARIES" ${ARGN})
  set_property(GLOBAL APPEND PROPERTY LUXEL_MODULES ${name})
  set_property(GLOBAL PROPERTY LUXEL_LIBRARIES_OF_${name} ${MODULE_LIBRARIES})
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/luxel/${name}/*.cpp)
  if(sources)
    add_library(luxel_${name} STATIC ${sources})
    # Position independent, so that the library can become part of a shared one; calls within a file are bound as in a
    # program, so this costs no time.
    set_target_properties(luxel_${name} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
    target_compile_options(luxel_${name} PRIVATE -fno-semantic-interposition)
    target_link_libraries(luxel_${name} PRIVATE luxel_flags ${MODULE_LIBRARIES} nlohmann_json::nlohmann_json
                          PUBLIC fmt::fmt glm::glm)
    luxel_compile_together(luxel_${name})
    set(visibility PUBLIC)
  else()
    add_library(luxel_${name} INTERFACE)
    target_link_libraries(luxel_${name} INTERFACE fmt::fmt glm::glm)
    set(visibility INTERFACE)
  endif()
  foreach(module ${MODULE_DEPENDS})
    target_link_libraries(luxel_${name} ${visibility} luxel_${module})
  endforeach()
endfunction()
