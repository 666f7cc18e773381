luxel_test(unit/refine_to_light ROOMS refine LIBRARIES luxel_truth_scenes)
