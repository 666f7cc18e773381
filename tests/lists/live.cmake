luxel_test(unit/live_scene ROOMS live)
