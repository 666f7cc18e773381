# The page of `luxel export -o room.html`: made of web/ when Luxel is built, and part of the program. Without Node.js and
# npm, or a network the first time, Luxel is built without it, and says so when a page is asked for.

find_program(LUXEL_NODE NAMES node nodejs)
find_program(LUXEL_NPM npm)
set(page_folder ${PROJECT_BINARY_DIR}/page)
file(MAKE_DIRECTORY ${page_folder})
# What was missing may be there now: the next build tries again.
if(EXISTS ${page_folder}/page_template.cpp)
  file(STRINGS ${page_folder}/page_template.cpp no_page LIMIT_COUNT 1 REGEX "^// no page$")
  if(no_page)
    file(REMOVE ${page_folder}/page_template.cpp)
  endif()
endif()
file(GLOB page_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/web/*)
add_custom_command(OUTPUT ${page_folder}/page_template.cpp
                   COMMAND ${CMAKE_COMMAND} -DSOURCES=${PROJECT_SOURCE_DIR}/web -DFOLDER=${page_folder} -DNODE=${LUXEL_NODE}
                           -DNPM=${LUXEL_NPM} -P ${PROJECT_SOURCE_DIR}/cmake/make_page.cmake
                   DEPENDS ${page_sources} ${PROJECT_SOURCE_DIR}/cmake/make_page.cmake
                   COMMENT "Making the page" VERBATIM)
target_sources(luxel_export PRIVATE ${page_folder}/page_template.cpp)
