luxel_test(unit/render ROOMS render)
luxel_test(unit/automatic_camera ROOMS render)
