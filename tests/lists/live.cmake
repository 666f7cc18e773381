luxel_test(unit/live_scene ROOMS live)
luxel_test(unit/live_instruments ROOMS live)
