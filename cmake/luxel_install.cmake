# What is installed: the library as other projects find it, find_package(luxel), and the command. docs/library.md is for
# who uses it, docs/install.md for who installs. COMPONENT: the package that a file belongs to, program or development.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

if(LUXEL_PROGRAM)
  set(LUXEL_ZSH_DIR ${CMAKE_INSTALL_DATADIR}/zsh/site-functions CACHE STRING "Folder of zsh's completion functions")
  mark_as_advanced(LUXEL_ZSH_DIR)
  install(TARGETS luxel COMPONENT program)
  # The program writes its manual and completions; DESTDIR is known only then.
  install(CODE "set(luxel_program \"$<TARGET_FILE:luxel>\")
set(luxel_man_folder \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_MANDIR}/man1\")
set(luxel_bash_file \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR}/bash-completion/completions/luxel\")
set(luxel_zsh_file \"\${CMAKE_INSTALL_PREFIX}/${LUXEL_ZSH_DIR}/_luxel\")
set(luxel_fish_file \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d/luxel.fish\")"
          COMPONENT program)
  install(SCRIPT ${CMAKE_CURRENT_LIST_DIR}/install_written.cmake COMPONENT program)
  # What other programs load.
  install(FILES integrations/paraview/luxel_light.py integrations/paraview/luxel_light.pvsm
          DESTINATION ${CMAKE_INSTALL_DATADIR}/luxel/paraview COMPONENT program)
  install(FILES integrations/blender/luxel_bake.py DESTINATION ${CMAKE_INSTALL_DATADIR}/luxel/blender COMPONENT program)
endif()
if(LUXEL_PROGRAM AND LUXEL_VIEWER)
  set(desktop_folder ${PROJECT_SOURCE_DIR}/tools/package/desktop)
  install(FILES ${desktop_folder}/luxel.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT program)
  install(FILES ${desktop_folder}/luxel.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps COMPONENT program)
  install(FILES ${desktop_folder}/luxel.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages COMPONENT program)
  install(FILES ${desktop_folder}/local.luxel.luxel.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo COMPONENT program)
endif()
if(luxel_uses_assimp)
  install(TARGETS luxel-import DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/luxel COMPONENT program)
endif()
# Where a program that links the installed library finds it.
set_source_files_properties(src/luxel/import/converter.cpp PROPERTIES
                            COMPILE_DEFINITIONS LUXEL_LIBEXEC="${CMAKE_INSTALL_FULL_LIBEXECDIR}/luxel")
install(TARGETS luxel_library EXPORT luxel-targets COMPONENT development FILE_SET HEADERS COMPONENT development)
set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/luxel)
install(EXPORT luxel-targets NAMESPACE luxel:: DESTINATION ${config_folder} COMPONENT development)
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
        DESTINATION ${config_folder} COMPONENT development)
