luxel_test(unit/image ROOMS image)
luxel_test(unit/write_image ROOMS image)
luxel_test(unit/read_image ROOMS image LIBRARIES PkgConfig::stb)
