# Rooms whose light is known patch by patch, and what is measured against them.
add_library(luxel_known_rooms STATIC support/point_factor.cpp support/dense_truth.cpp support/known_rooms.cpp
                                     support/error_bars.cpp)
target_link_libraries(luxel_known_rooms PRIVATE luxel_flags PUBLIC luxel_truth_scenes luxel_solution luxel_patch
                                                                   luxel_parallel)
luxel_test(truth/dense_truth ROOMS patch LIBRARIES luxel_known_rooms)
luxel_test(statistics/error_judge ROOMS solution LIBRARIES luxel_known_rooms)
luxel_test(truth/sampled ROOMS solve LIBRARIES luxel_known_rooms)
luxel_test(statistics/error_bar ROOMS solve LIBRARIES luxel_known_rooms)
luxel_test(repeat/sampled ROOMS solve LIBRARIES luxel_truth_scenes)
luxel_test(statistics/sharing ROOMS solve LIBRARIES luxel_known_rooms)
luxel_test(truth/form_factors ROOMS transport LIBRARIES luxel_known_rooms)
luxel_test(truth/thin_things ROOMS solve reference load LIBRARIES luxel_truth_scenes)
luxel_test(truth/relight ROOMS solve LIBRARIES luxel_known_rooms)
luxel_test(statistics/merge ROOMS solve LIBRARIES luxel_known_rooms)
luxel_test(repeat/resume ROOMS solve LIBRARIES luxel_truth_scenes)
luxel_test(truth/textures ROOMS solve)
luxel_test(truth/point_lights ROOMS solve reference LIBRARIES luxel_truth_scenes)
