# What every target of the project is compiled with, and luxel_module(): one static library per module, so that a module
# links, and sees the headers of, only the outside libraries whose home it is.

include(${CMAKE_CURRENT_LIST_DIR}/luxel_outside_libraries.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/luxel_outside_targets.cmake)

# For every target of the project. -ffp-contract=off and no -march: the same source gives the same bits on every host.
add_library(luxel_flags INTERFACE)
target_compile_features(luxel_flags INTERFACE cxx_std_20)
target_compile_options(luxel_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                                             $<$<BOOL:${LUXEL_WERROR}>:-Werror> -ffp-contract=off -fno-math-errno)
target_include_directories(luxel_flags INTERFACE ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src)
if(LUXEL_SANITIZE)
  target_compile_options(luxel_flags INTERFACE -fsanitize=${LUXEL_SANITIZE} -fno-sanitize-recover=all
                                               -fno-omit-frame-pointer
                                               -Wno-maybe-uninitialized)  # gcc 12 reports std::optional falsely then
  target_link_options(luxel_flags INTERFACE -fsanitize=${LUXEL_SANITIZE})
endif()
if(LUXEL_SANITIZE MATCHES "thread" AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(luxel_flags INTERFACE -Wno-tsan)  # gcc: fences are not followed; the suppressions explain where
endif()

if(LUXEL_COVERAGE)
  target_compile_options(luxel_flags INTERFACE --coverage -fprofile-update=atomic)
  target_link_options(luxel_flags INTERFACE --coverage)
endif()

if(LUXEL_FUZZ)
  target_compile_options(luxel_flags INTERFACE -fsanitize=fuzzer-no-link,address,undefined
                                               -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
endif()

# Headers that most files of the modules include are compiled once: this saves a third of their time. Only with gcc, for
# which it is measured; not under ccache, which cannot cache with them; not in another project's build. clang-tidy and the
# test of single headers read without them, and so find an include that is missing.
if(PROJECT_IS_TOP_LEVEL AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/common_headers.cpp CONTENT "")
  add_library(luxel_common_headers STATIC ${PROJECT_BINARY_DIR}/common_headers.cpp)
  set_target_properties(luxel_common_headers PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
  target_compile_options(luxel_common_headers PRIVATE -fno-semantic-interposition)
  target_link_libraries(luxel_common_headers PRIVATE luxel_flags fmt::fmt glm::glm)
  target_compile_options(luxel_flags INTERFACE -pthread)  # as OpenEXR asks for: the flags must be the same everywhere
  target_precompile_headers(luxel_common_headers PRIVATE <algorithm> <array> <cmath> <filesystem> <functional> <memory>
                            <optional> <span> <string> <string_view> <variant> <vector> <fmt/format.h> <glm/glm.hpp>)
endif()

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
    if(TARGET luxel_common_headers)
      target_precompile_headers(luxel_${name} REUSE_FROM luxel_common_headers)
    endif()
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
