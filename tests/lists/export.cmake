luxel_test(unit/export_glb ROOMS export LIBRARIES TinyGLTF)
luxel_test(unit/export_ply ROOMS export)
luxel_test(unit/valid_utf8 ROOMS export)
luxel_test(unit/page_data ROOMS export)
