luxel_test(unit/solution_file ROOMS solution)
luxel_test(unit/solution_damage ROOMS solution LIBRARIES luxel_hdf5)

# Readers that are not ours: VTK's own and h5py, on files of one, three and seven bands.
add_executable(write_sample_solution support/write_sample_solution.cpp)
target_include_directories(write_sample_solution PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(write_sample_solution PRIVATE luxel_flags luxel_solution)
add_test(NAME unit/solution_readers
         COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/unit/solution_readers.py
                 $<TARGET_FILE:write_sample_solution>)
set_tests_properties(unit/solution_readers PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 120)
