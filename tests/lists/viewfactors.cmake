luxel_test(truth/view_factors ROOMS viewfactors LIBRARIES luxel_truth_scenes)
luxel_test(statistics/view_factors ROOMS viewfactors LIBRARIES luxel_truth_scenes)
luxel_test(repeat/view_factors ROOMS viewfactors LIBRARIES luxel_truth_scenes)
luxel_test(unit/enforce ROOMS viewfactors)
