luxel_test(unit/view ROOMS view)
luxel_test(unit/window ROOMS window)
