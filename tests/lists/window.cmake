luxel_test(unit/view ROOMS view)
luxel_test(unit/window ROOMS window)
luxel_test(cli/view ROOMS file image)
add_dependencies(cli_view_test luxel)
