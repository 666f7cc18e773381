luxel_test(unit/tone_curve ROOMS tone)
luxel_test(unit/tone_map ROOMS tone)
luxel_test(unit/blur ROOMS tone)
