luxel_test(unit/lightmap_charts ROOMS lightmap LIBRARIES luxel_truth_scenes)
luxel_test(truth/lightmap ROOMS lightmap solve LIBRARIES luxel_truth_scenes luxel_known_rooms)
luxel_test(cli/lightmap ROOMS file image LIBRARIES nlohmann_json::nlohmann_json)
add_dependencies(cli_lightmap_test luxel)
