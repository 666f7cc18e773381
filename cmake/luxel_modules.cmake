# Warnings, and luxel_module(): one static library per module, so that a module links, and sees the headers of, only the
# outside libraries whose home it is.

include(${CMAKE_CURRENT_LIST_DIR}/luxel_libraries.cmake)
find_package(CLI11 REQUIRED)
# The window's libraries: only the program needs them.
if(LUXEL_VIEWER)
  pkg_check_modules(epoxy REQUIRED IMPORTED_TARGET epoxy)
  find_package(glfw3 3.3 REQUIRED)
  pkg_check_modules(imgui REQUIRED IMPORTED_TARGET imgui)
endif()

# For every target of the project. -ffp-contract=off and no -march: the same source gives the same bits on every host.
add_library(luxel_flags INTERFACE)
target_compile_options(luxel_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                                             -Werror -ffp-contract=off -fno-math-errno)
target_include_directories(luxel_flags INTERFACE ${PROJECT_SOURCE_DIR}/src)
if(LUXEL_SANITIZE)
  target_compile_options(luxel_flags INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=undefined
                                               -fno-omit-frame-pointer
                                               -Wno-maybe-uninitialized)  # gcc 12 reports std::optional falsely then
  target_link_options(luxel_flags INTERFACE -fsanitize=address,undefined)
endif()

if(LUXEL_COVERAGE)
  target_compile_options(luxel_flags INTERFACE --coverage -fprofile-update=atomic)
  target_link_options(luxel_flags INTERFACE --coverage)
endif()

if(LUXEL_FUZZ)
  target_compile_options(luxel_flags INTERFACE -fsanitize=fuzzer-no-link,address,undefined
                                               -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
endif()

# fmt formats text and glm gives the vectors in signatures: every module may include them.
function(luxel_module name)
  cmake_parse_arguments(MODULE "" "" "DEPENDS;LIBRARIES" ${ARGN})
  set_property(GLOBAL APPEND PROPERTY LUXEL_MODULES ${name})
  set_property(GLOBAL PROPERTY LUXEL_LIBRARIES_OF_${name} ${MODULE_LIBRARIES})
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/luxel/${name}/*.cpp)
  if(sources)
    add_library(luxel_${name} STATIC ${sources})
    target_link_libraries(luxel_${name} PRIVATE luxel_flags ${MODULE_LIBRARIES} PUBLIC fmt::fmt glm::glm)
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
