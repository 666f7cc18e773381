luxel_test(unit/patch_tree ROOMS patch LIBRARIES luxel_truth_scenes)
