# What is installed: the library as other projects find it, find_package(luxel), and the program. docs/library.md is
# for who uses it.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# The public headers. The program uses no others, and they include no others: tools/check_layers.py looks.
set(LUXEL_PUBLIC_HEADERS
    math/bounds.h math/vector.h
    report/error.h report/log.h report/memory.h report/progress.h report/time_left.h
    photometry/band_colours.h photometry/colour_spectra.h photometry/luminous_efficacy.h photometry/spectrum.h
    photometry/waveband.h
    file/ending_of.h file/output_file.h
    gltf/is_gltf.h
    parallel/ranks.h parallel/workers.h
    cluster/mpi_ranks.h
    image/image.h image/image_file.h image/raster.h
    scene/camera.h scene/material.h scene/name_pattern.h scene/point_light.h
    scene/scene.h scene/texture.h
    mesh/clean_triangles.h mesh/edges.h mesh/pieces.h mesh/rims.h mesh/t_junctions.h mesh/vertex_weld.h
    load/load_scene.h
    patch/colour_patches.h patch/focus.h patch/light_groups.h patch/flat_polygon.h patch/make_patches.h patch/patch_set.h patch/open_polygons.h patch/patch_tree.h patch/uncut_faces.h
    trace/point_sight.h trace/tracer.h
    solution/error_95th.h solution/merge_solutions.h solution/sample_state.h solution/solution.h solution/solution_file.h
    transport/choose_portals.h transport/dense_operator.h transport/form_factor_row.h transport/gather_sides.h transport/hemicube.h
    transport/hemicube_operator.h transport/hemicube_pixels.h transport/lamp_check.h transport/lines_operator.h
    transport/operator.h transport/row_operator.h
    check/diagnose.h check/fault_mesh.h check/finding.h check/light_walks.h check/openings.h check/scanned_mesh.h
    check/words.h
    solve/bounces.h solve/classical.h solve/energy.h solve/forecast.h solve/jacobi.h solve/relight.h solve/sampled.h solve/seen_solution.h
    solve/solve_light.h solve/solve_report.h solve/stochastic_jacobi.h solve/surface_means.h
    viewfactors/check_view_factors.h viewfactors/enforce.h viewfactors/exact_view_factors.h
    viewfactors/sample_view_factors.h viewfactors/view_elements.h viewfactors/view_factors.h
    viewfactors/view_factors_file.h
    surface/smooth_light.h surface/vertex_fit.h
    refine/refine_to_light.h
    tone/tone.h
    render/automatic_camera.h render/render.h
    reference/batch_means.h reference/compare.h reference/difference_picture.h reference/final_gather.h
    reference/lamp_table.h reference/light_paths.h reference/path_picture.h reference/path_traced.h
    reference/surface_point.h
    lightmap/dilate.h lightmap/gather_texels.h lightmap/given_layout.h lightmap/lightmap.h lightmap/lightmap_picture.h lightmap/make_charts.h lightmap/make_lightmap.h
    lightmap/new_layout.h lightmap/pack_charts.h lightmap/radiance_pages.h lightmap/side_edges.h lightmap/solve_seams.h
    export/export_coloured.h export/export_kept.h export/export_mesh.h export/kept_layout.h export/export_page.h
    export/mesh_program.h
    live/light_value.h live/live_answers.h live/live_scene.h live/live_settings.h live/live_state.h live/patch_levels.h live/probe.h
    live/sample_rays.h live/tree_boxes.h)

# Rooms of the program alone, so that whoever uses the library needs no display.
set(LUXEL_PROGRAM_ROOMS view window)

# All others as one library, luxel::luxel.
get_property(rooms GLOBAL PROPERTY LUXEL_ROOMS)
list(REMOVE_ITEM rooms ${LUXEL_PROGRAM_ROOMS})
set(objects)
set(libraries fmt::fmt glm::glm)
foreach(room ${rooms})
  get_target_property(type luxel_${room} TYPE)
  if(NOT type STREQUAL "INTERFACE_LIBRARY")
    list(APPEND objects $<TARGET_OBJECTS:luxel_${room}>)
  endif()
  get_property(of_room GLOBAL PROPERTY LUXEL_LIBRARIES_OF_${room})
  list(APPEND libraries ${of_room})
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
