luxel_test(unit/live_scene ROOMS live)
luxel_test(unit/live_methods ROOMS live)
luxel_test(unit/live_instruments ROOMS live LIBRARIES luxel_truth_scenes)
