luxel_test(cli/program ROOMS file LIBRARIES nlohmann_json::nlohmann_json)
add_dependencies(cli_program_test luxel)
