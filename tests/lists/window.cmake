luxel_test(unit/view ROOMS view)
