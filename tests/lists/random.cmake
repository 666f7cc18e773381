luxel_test(unit/sobol ROOMS random)
