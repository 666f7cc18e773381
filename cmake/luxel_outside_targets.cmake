# Targets for outside libraries that bring none of their own everywhere: luxel::hdf5, luxel::openexr, luxel::stb, and for
# optional ones: luxel::mpi, luxel::draco, luxel::meshoptimizer and luxel::webp. Our own build includes this file, and so
# does the installed package. luxel_uses_NAME: whether Luxel is built with that optional library.

# HDF5 by pkg-config, since CMake's search needs C enabled in the project; by that search where pkg-config has none.
if(NOT TARGET luxel::hdf5)
  add_library(luxel::hdf5 INTERFACE IMPORTED)
  pkg_search_module(luxel_hdf5 QUIET IMPORTED_TARGET hdf5 hdf5-serial)
  if(luxel_hdf5_FOUND)
    target_link_libraries(luxel::hdf5 INTERFACE PkgConfig::luxel_hdf5)
  else()
    enable_language(C)
    find_package(HDF5 REQUIRED COMPONENTS C)
    target_include_directories(luxel::hdf5 SYSTEM INTERFACE ${HDF5_C_INCLUDE_DIRS})
    target_compile_definitions(luxel::hdf5 INTERFACE ${HDF5_C_DEFINITIONS})
    target_link_libraries(luxel::hdf5 INTERFACE ${HDF5_C_LIBRARIES})
  endif()
endif()

foreach(luxel_library OpenEXR stb)
  string(TOLOWER luxel::${luxel_library} luxel_target)
  if(NOT TARGET ${luxel_target})
    add_library(${luxel_target} INTERFACE IMPORTED)
    pkg_check_modules(luxel_${luxel_library} REQUIRED QUIET IMPORTED_TARGET ${luxel_library})
    target_link_libraries(${luxel_target} INTERFACE PkgConfig::luxel_${luxel_library})
  endif()
endforeach()

# Without MPI the target is empty: a run is one process.
if(NOT TARGET luxel::mpi)
  add_library(luxel::mpi INTERFACE IMPORTED)
  if(luxel_uses_mpi)
    target_link_libraries(luxel::mpi INTERFACE MPI::MPI_CXX)
    target_compile_definitions(luxel::mpi INTERFACE LUXEL_HAS_MPI OMPI_SKIP_MPICXX MPICH_SKIP_MPICXX)
  endif()
endif()

# luxel_optional_library(NAME TARGET): luxel::NAME, which links TARGET and says so to the sources. Without the library it is
# empty, and files that need it are refused.
function(luxel_optional_library name target)
  if(TARGET luxel::${name})
    return()
  endif()
  add_library(luxel::${name} INTERFACE IMPORTED)
  if(luxel_uses_${name})
    string(TOUPPER ${name} upper)
    target_link_libraries(luxel::${name} INTERFACE ${target})
    target_compile_definitions(luxel::${name} INTERFACE LUXEL_HAS_${upper})
  endif()
endfunction()

luxel_optional_library(draco draco::draco)
luxel_optional_library(meshoptimizer meshoptimizer::meshoptimizer)
if(luxel_uses_webp AND NOT TARGET luxel::webp)
  pkg_check_modules(luxel_webp REQUIRED QUIET IMPORTED_TARGET libwebp)
endif()
luxel_optional_library(webp PkgConfig::luxel_webp)
