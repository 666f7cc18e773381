luxel_test(unit/spectra ROOMS photometry)
luxel_test(unit/scene ROOMS scene)
