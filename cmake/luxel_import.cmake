# The program luxel-import: beside the command in the build folder, and in libexec/luxel where it is installed.
add_executable(luxel-import $<TARGET_OBJECTS:luxel_conversion>)
set_target_properties(luxel-import PROPERTIES LINKER_LANGUAGE CXX)
target_link_libraries(luxel-import PRIVATE luxel_flags luxel_import PkgConfig::assimp fmt::fmt)
