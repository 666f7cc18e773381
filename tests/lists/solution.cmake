luxel_test(unit/solution_file ROOMS solution)
luxel_test(unit/error_95th ROOMS solution)
luxel_test(unit/solution_damage ROOMS solution LIBRARIES luxel_hdf5)

# Readers that are not ours: VTK's own and h5py, on files of one, three and seven bands.
add_executable(write_sample_solution support/write_sample_solution.cpp)
target_include_directories(write_sample_solution PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(write_sample_solution PRIVATE luxel_flags luxel_solution)
foreach(reader vtk h5py)
  add_test(NAME unit/solution_read_by_${reader}
           COMMAND /usr/bin/python3 -B ${CMAKE_CURRENT_SOURCE_DIR}/unit/solution_readers.py ${reader}
                   $<TARGET_FILE:write_sample_solution>)
  set_tests_properties(unit/solution_read_by_${reader} PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 120)
endforeach()
