luxel_test(unit/ending_of ROOMS file gltf)
luxel_test(unit/output_file ROOMS file)
luxel_test(unit/read_file ROOMS file)
luxel_test(unit/compact ROOMS file LIBRARIES ZLIB::ZLIB)
