luxel_test(unit/place_views ROOMS views LIBRARIES luxel_truth_scenes)
luxel_test(unit/seen_error ROOMS views LIBRARIES luxel_truth_scenes)
luxel_test(truth/seen_error ROOMS solve LIBRARIES luxel_truth_scenes)
