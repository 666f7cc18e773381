luxel_test(unit/trig ROOMS math)
luxel_test(unit/lamps ROOMS transport LIBRARIES luxel_truth_scenes)
luxel_test(unit/sampled_operator ROOMS transport LIBRARIES luxel_truth_scenes)
luxel_test(statistics/direct_light ROOMS transport LIBRARIES luxel_truth_scenes)
