# Finds the outside libraries that a build of Luxel needs.

set(luxel_uses_mpi OFF)
if(LUXEL_MPI)
  # The compiler wrapper may be installed without the headers; CMake's own search stops with an error then.
  find_program(LUXEL_MPI_COMPILER mpicxx)
  mark_as_advanced(LUXEL_MPI_COMPILER)
  if(LUXEL_MPI_COMPILER)
    execute_process(COMMAND ${LUXEL_MPI_COMPILER} -x c++ -include mpi.h -fsyntax-only /dev/null
                    RESULT_VARIABLE luxel_mpi_fails OUTPUT_QUIET ERROR_QUIET)
    if(NOT luxel_mpi_fails)
      find_package(MPI QUIET COMPONENTS CXX)
      set(luxel_uses_mpi ${MPI_CXX_FOUND})
    endif()
  endif()
endif()
if(LUXEL_MPI STREQUAL "REQUIRED" AND NOT luxel_uses_mpi)
  message(FATAL_ERROR "LUXEL_MPI is REQUIRED, but MPI with its headers was not found; set it to ON to build without")
endif()
find_package(PkgConfig REQUIRED)

# Libraries of compressed files, and Assimp: without one of them the program refuses such a file and names what to install.
# luxel_optional(NAME FOUND): luxel_uses_NAME is ON where its option is not OFF and the library is there.
macro(luxel_optional name found)
  string(TOUPPER ${name} luxel_option)
  set(luxel_uses_${name} OFF)
  if(LUXEL_${luxel_option} AND ${found})
    set(luxel_uses_${name} ON)
  endif()
  if(LUXEL_${luxel_option} STREQUAL "REQUIRED" AND NOT luxel_uses_${name})
    message(FATAL_ERROR "LUXEL_${luxel_option} is REQUIRED, but ${name} was not found; set it to ON to build without")
  endif()
endmacro()
find_package(draco CONFIG QUIET)
find_package(meshoptimizer CONFIG QUIET)
pkg_check_modules(luxel_webp QUIET libwebp)
luxel_optional(draco draco_FOUND)
luxel_optional(meshoptimizer meshoptimizer_FOUND)
luxel_optional(webp luxel_webp_FOUND)
# Of the program luxel-import alone, which only the command or an installed library can find.
pkg_check_modules(assimp QUIET IMPORTED_TARGET assimp)
luxel_optional(assimp assimp_FOUND)
if(NOT LUXEL_PROGRAM AND NOT LUXEL_INSTALL)
  set(luxel_uses_assimp OFF)
endif()

find_package(Threads REQUIRED)
find_package(glm REQUIRED)
find_package(fmt REQUIRED)
find_package(TBB REQUIRED)
find_package(embree 3.13 REQUIRED)
find_package(ZLIB REQUIRED)
find_package(PNG REQUIRED)

# Headers alone: a user of the built library does without it.
find_package(nlohmann_json REQUIRED)

# Of the command alone.
if(LUXEL_PROGRAM)
  find_package(CLI11 REQUIRED)
endif()
if(LUXEL_VIEWER)
  pkg_check_modules(epoxy REQUIRED IMPORTED_TARGET epoxy)
  find_package(glfw3 3.3 REQUIRED)
  pkg_check_modules(imgui REQUIRED IMPORTED_TARGET imgui)
endif()
