luxel_test(unit/scene ROOMS scene)
