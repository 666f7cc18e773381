luxel_test(unit/trig ROOMS math)
