luxel_test(unit/contacts ROOMS patch random LIBRARIES luxel_truth_scenes)
luxel_test(unit/triangle_pairs ROOMS patch random)
luxel_test(unit/refine_patches ROOMS patch random LIBRARIES luxel_truth_scenes)
luxel_test(unit/patch_tree ROOMS patch LIBRARIES luxel_truth_scenes)
