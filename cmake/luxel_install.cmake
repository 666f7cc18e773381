# What is installed: the library as other projects find it, find_package(luxel), and the program. docs/library.md is
# for who uses it.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# The public headers. The program uses no others, and they include no others: tools/check_layers.py looks.
set(LUXEL_PUBLIC_HEADERS
    core/bounds.h core/vector.h
    core/error.h core/log.h core/memory.h core/progress.h core/time_left.h
    scene/band_colours.h scene/colour_spectra.h scene/luminous_efficacy.h scene/spectrum.h
    scene/waveband.h
    core/ending_of.h core/output_file.h
    import/is_gltf.h
    core/ranks.h core/workers.h
    core/mpi_ranks.h
    image/image.h image/image_file.h image/raster.h
    scene/camera.h scene/material.h scene/name_pattern.h scene/point_light.h
    scene/scene.h scene/texture.h
    scene/clean_triangles.h scene/edges.h scene/components.h scene/boundary_loops.h scene/t_junctions.h scene/vertex_weld.h
    import/load_scene.h
    patch/colour_patches.h patch/focus.h patch/light_groups.h patch/flat_polygon.h patch/make_patches.h patch/patch_set.h patch/open_polygons.h patch/patch_tree.h patch/uncut_faces.h
    trace/point_sight.h trace/tracer.h
    solution/error_95th.h solution/merge_solutions.h solution/sample_state.h solution/solution.h solution/solution_file.h solution/stop_reason.h
    lamps/choose_portals.h classical/dense_operator.h classical/form_factor_row.h trace/gather_sides.h classical/hemicube.h
    classical/hemicube_operator.h classical/hemicube_pixels.h lamps/lamp_check.h classical/lines_operator.h
    classical/operator.h classical/row_operator.h
    session/diagnose.h session/diagnostic_mesh.h session/diagnostic.h session/light_walks.h session/openings.h session/scanned_mesh.h
    session/words.h
    solve/bounces.h classical/classical.h classical/energy.h classical/forecast.h classical/jacobi.h solve/relight.h solve/sampled.h solve/seen_solution.h
    solve/solve_light.h classical/solve_report.h classical/stochastic_jacobi.h classical/surface_means.h
    form_factors/check_view_factors.h form_factors/enforce.h form_factors/exact_view_factors.h
    form_factors/sample_view_factors.h form_factors/view_elements.h form_factors/view_factors.h
    form_factors/view_factors_file.h
    surface/smooth_light.h surface/vertex_fit.h
    solve/refine_to_light.h
    image/tone.h
    render/automatic_camera.h render/render.h
    render/batch_means.h render/compare.h render/difference_picture.h render/final_gather.h
    render/lamp_table.h render/light_paths.h render/path_picture.h render/path_traced.h
    render/surface_point.h
    render/dilate.h render/gather_texels.h surface/given_layout.h render/lightmap.h render/lightmap_picture.h surface/make_charts.h render/make_lightmap.h
    render/new_layout.h surface/pack_charts.h render/radiance_pages.h surface/side_edges.h render/solve_seams.h
    export/export_coloured.h export/export_round_trip.h export/export_mesh.h export/round_trip_layout.h export/export_page.h
    export/target_application.h
    session/light_value.h session/live_answers.h session/live_scene.h session/live_settings.h session/live_state.h session/patch_levels.h session/probe.h
    session/sample_rays.h session/tree_boxes.h)

# Modules of the program alone, so that whoever uses the library needs no display.
set(LUXEL_PROGRAM_MODULES viewer)

# All others as one library, luxel::luxel.
get_property(modules GLOBAL PROPERTY LUXEL_MODULES)
list(REMOVE_ITEM modules ${LUXEL_PROGRAM_MODULES})
set(objects)
set(libraries fmt::fmt glm::glm)
foreach(module ${modules})
  get_target_property(type luxel_${module} TYPE)
  if(NOT type STREQUAL "INTERFACE_LIBRARY")
    list(APPEND objects $<TARGET_OBJECTS:luxel_${module}>)
  endif()
  get_property(libraries_of_module GLOBAL PROPERTY LUXEL_LIBRARIES_OF_${module})
  list(APPEND libraries ${libraries_of_module})
endforeach()
list(REMOVE_DUPLICATES libraries)
add_library(luxel_library STATIC ${objects})
set_target_properties(luxel_library PROPERTIES OUTPUT_NAME luxel EXPORT_NAME luxel LINKER_LANGUAGE CXX)
target_compile_features(luxel_library INTERFACE cxx_std_20)
target_include_directories(luxel_library INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)

install(TARGETS luxel)
install(TARGETS luxel_library EXPORT luxel-targets)
foreach(header ${LUXEL_PUBLIC_HEADERS})
  get_filename_component(folder ${header} DIRECTORY)
  install(FILES src/luxel/${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/luxel/${folder})
endforeach()
set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/luxel)
install(EXPORT luxel-targets NAMESPACE luxel:: DESTINATION ${config_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/luxel-config-version.cmake COMPATIBILITY SameMinorVersion)
configure_file(cmake/luxel-config.cmake.in luxel-config.cmake @ONLY)  # with the outside libraries, to be found anew
install(FILES ${PROJECT_BINARY_DIR}/luxel-config.cmake ${PROJECT_BINARY_DIR}/luxel-config-version.cmake
              cmake/luxel_libraries.cmake
        DESTINATION ${config_folder})
