luxel_test(cli/program ROOMS file LIBRARIES nlohmann_json::nlohmann_json)
add_dependencies(cli_program_test luxel)
luxel_test(cli/sampled ROOMS file LIBRARIES nlohmann_json::nlohmann_json)
add_dependencies(cli_sampled_test luxel)
