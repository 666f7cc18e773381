# cmake -DSOURCES=web -DFOLDER=build/.../page -DNODE=... -DNPM=... -P make_page.cmake
# Makes FOLDER/page_template.cpp: the page, or the reason why there is none. It never fails: Luxel is built without a page
# where Node.js is missing.

set(out ${FOLDER}/page_template.cpp)

function(without_page reason)
  message("The page of 'luxel export -o room.html' is left out: ${reason}.")
  file(WRITE ${out} "// SPDX-License-Identifier: Apache-2.0
// no page
#include \"luxel/export/page_template.h\"

namespace luxel {

std::string_view page_template() { return {}; }
std::string_view page_obstacle() { return \"${reason}\"; }

}  // namespace luxel
")
endfunction()

if(NOT NODE OR NOT NPM)
  without_page("Node.js or npm was not there")
  return()
endif()
file(READ ${SOURCES}/package.json wanted)
set(have "")
if(EXISTS ${FOLDER}/fetched.json)
  file(READ ${FOLDER}/fetched.json have)
endif()
if(NOT have STREQUAL wanted)
  file(WRITE ${FOLDER}/package.json "${wanted}")
  # The versions in package.json are exact; a lock file would only add where they were fetched from.
  execute_process(COMMAND ${NPM} --prefix ${FOLDER} install --no-package-lock --ignore-scripts --no-audit --no-fund
                          --prefer-offline --fetch-retries 1 --fetch-timeout 60000
                  OUTPUT_FILE ${FOLDER}/npm.log ERROR_FILE ${FOLDER}/npm.log RESULT_VARIABLE failed TIMEOUT 300)
  if(failed)
    without_page("npm could not fetch three.js and esbuild")
    return()
  endif()
  file(WRITE ${FOLDER}/fetched.json "${wanted}")
endif()
execute_process(COMMAND ${NODE} ${SOURCES}/build.mjs ${SOURCES} ${FOLDER}/node_modules ${out}
                ERROR_VARIABLE complaint RESULT_VARIABLE failed TIMEOUT 120)
if(failed)
  file(WRITE ${FOLDER}/bundle.log "${complaint}")
  message("${complaint}")
  without_page("it could not be bundled")
endif()
