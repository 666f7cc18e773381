luxel_test(unit/smooth_light ROOMS surface)
luxel_test(unit/smooth_surfaces ROOMS surface)
luxel_test(unit/reconstruction ROOMS surface random)
luxel_test(unit/radiance_of ROOMS surface)
