# The program luxel-import: beside the command in the build folder, and in libexec/luxel where it is installed. The library and
# the command run it and do not link it.
file(GLOB luxel_import_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/luxel/import/child/*.cpp)
add_executable(luxel-import ${luxel_import_sources})
luxel_compile_together(luxel-import)
target_link_libraries(luxel-import PRIVATE luxel_flags luxel_import PkgConfig::assimp fmt::fmt nlohmann_json::nlohmann_json)
