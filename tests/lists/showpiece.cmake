luxel_test(unit/showpiece ROOMS showpiece_scene)
luxel_test(unit/showpiece_solids ROOMS showpiece_scene)
luxel_test(unit/cornell_box ROOMS load)
