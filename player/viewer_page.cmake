# The page that plays recordings: its decoder is built by the preset `page`, everything is put into one
# file, and that into ribbon-play. .ci/setup.sh fetches what it needs.
find_program(RIBBON_EMCC emcc)
set(page_sources ${PROJECT_SOURCE_DIR}/build/page-sources)
if(RIBBON_EMCC AND EXISTS ${page_sources}/complete)
  set(can_build_page ON)
else()
  set(can_build_page OFF)
endif()
option(RIBBON_BUILD_PAGE "Build the page that plays recordings, by Emscripten" ${can_build_page})
if(NOT RIBBON_BUILD_PAGE)
  return()
endif()

set(decoder ${PROJECT_SOURCE_DIR}/build/page)
set(in_source_folder ${CMAKE_COMMAND} -E chdir ${PROJECT_SOURCE_DIR} ${CMAKE_COMMAND})
include(ExternalProject)
ExternalProject_Add(page_decoder
  SOURCE_DIR ${PROJECT_SOURCE_DIR}
  BINARY_DIR ${decoder}
  CONFIGURE_COMMAND ${in_source_folder} --preset page
  BUILD_COMMAND ${in_source_folder} --build --preset page --parallel 2 --target playback
  BUILD_ALWAYS ON
  BUILD_BYPRODUCTS ${decoder}/player/page/playback.js ${decoder}/player/page/playback.wasm
  INSTALL_COMMAND "")

add_executable(bundle_page page/base64.cpp page/bundle_page.cpp page/page_parts.cpp)
target_include_directories(bundle_page PRIVATE ${PROJECT_SOURCE_DIR})
target_link_libraries(bundle_page PRIVATE ribbon_files ribbon_commandline ${RIBBON_LIBDEFLATE})
ribbon_precompiled(bundle_page)

set(viewer_page ${CMAKE_CURRENT_BINARY_DIR}/viewer.html)
set(page_texts ${CMAKE_CURRENT_SOURCE_DIR}/page)
add_custom_command(
  OUTPUT ${viewer_page}
  COMMAND bundle_page ${page_texts}/page.html ${decoder}/player/page ${viewer_page}
  DEPENDS bundle_page page_decoder ${decoder}/player/page/playback.js
          ${decoder}/player/page/playback.wasm ${page_texts}/page.html ${page_texts}/page.css
          ${page_texts}/page.js ${page_texts}/timeline.js ${page_texts}/view.js
          ${page_texts}/worker.js)
set_source_files_properties(page/viewer_page.cpp PROPERTIES
  COMPILE_DEFINITIONS RIBBON_VIEWER_PAGE="${viewer_page}"
  OBJECT_DEPENDS ${viewer_page})
