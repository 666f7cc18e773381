luxel_test(truth/enclosures ROOMS solve LIBRARIES luxel_truth_scenes)
