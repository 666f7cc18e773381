# What is installed: the library as other projects find it, find_package(luxel), and the command. docs/library.md is for
# who uses it.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

if(LUXEL_PROGRAM)
  install(TARGETS luxel)
endif()
if(luxel_uses_assimp)
  install(TARGETS luxel-import DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/luxel)
endif()
# Where a program that links the installed library finds it.
set_source_files_properties(src/luxel/import/converter.cpp PROPERTIES
                            COMPILE_DEFINITIONS LUXEL_LIBEXEC="${CMAKE_INSTALL_FULL_LIBEXECDIR}/luxel")
install(TARGETS luxel_library EXPORT luxel-targets FILE_SET HEADERS)
set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/luxel)
install(EXPORT luxel-targets NAMESPACE luxel:: DESTINATION ${config_folder})
set(luxel_used_libraries)
foreach(library draco meshoptimizer webp)
  if(luxel_uses_${library})
    string(APPEND luxel_used_libraries " ${library}")
  endif()
endforeach()
configure_package_config_file(cmake/luxel-config.cmake.in luxel-config.cmake INSTALL_DESTINATION ${config_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/luxel-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/luxel-config.cmake ${PROJECT_BINARY_DIR}/luxel-config-version.cmake
              cmake/luxel_outside_targets.cmake
        DESTINATION ${config_folder})
