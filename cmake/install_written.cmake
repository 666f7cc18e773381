# Runs at installation: the program writes its manual pages and its completions to their places, which luxel_install.cmake
# sets, and they are entered into the manifest.

function(luxel_run)
  execute_process(COMMAND ${luxel_program} ${ARGN} RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "'luxel ${ARGN}' failed: the manual pages and the completions are not installed")
  endif()
endfunction()

message(STATUS "Installing: ${luxel_man_folder}/luxel*.1 and completions of bash, zsh and fish")
luxel_run(manual $ENV{DESTDIR}${luxel_man_folder})
file(GLOB luxel_pages RELATIVE $ENV{DESTDIR}${luxel_man_folder} $ENV{DESTDIR}${luxel_man_folder}/luxel*.1)
list(TRANSFORM luxel_pages PREPEND ${luxel_man_folder}/)
list(APPEND CMAKE_INSTALL_MANIFEST_FILES ${luxel_pages})
foreach(luxel_shell bash zsh fish)
  set(luxel_file ${luxel_${luxel_shell}_file})
  get_filename_component(luxel_folder $ENV{DESTDIR}${luxel_file} DIRECTORY)
  file(MAKE_DIRECTORY ${luxel_folder})
  luxel_run(completion ${luxel_shell} OUTPUT_FILE $ENV{DESTDIR}${luxel_file})
  list(APPEND CMAKE_INSTALL_MANIFEST_FILES ${luxel_file})
endforeach()
