# Pages that run libribbon in a browser: their modules are built by the preset `page`, everything that a
# page loads is put into one file, and that into the tool that writes it. .ci/setup.sh fetches what they
# need.
find_program(RIBBON_EMCC emcc)
if(RIBBON_EMCC AND EXISTS ${PROJECT_SOURCE_DIR}/build/page-sources/complete)
  set(can_build_page ON)
else()
  set(can_build_page OFF)
endif()
# Not `option`: what could not be built once would stay unbuilt in that build folder.
include(CMakeDependentOption)
cmake_dependent_option(
  RIBBON_BUILD_PAGE "Build the pages that tools write, by Emscripten" ON can_build_page OFF)

if(RIBBON_BUILD_PAGE)
  set(RIBBON_PAGE_MODULES ${PROJECT_SOURCE_DIR}/build/page)
  set(in_source_folder ${CMAKE_COMMAND} -E chdir ${PROJECT_SOURCE_DIR} ${CMAKE_COMMAND})
  set(built)
  foreach(module player/page/playback recorder/page/sketch)
    list(APPEND built ${RIBBON_PAGE_MODULES}/${module}.js ${RIBBON_PAGE_MODULES}/${module}.wasm)
  endforeach()
  include(ExternalProject)
  ExternalProject_Add(page_modules
    SOURCE_DIR ${PROJECT_SOURCE_DIR}
    BINARY_DIR ${RIBBON_PAGE_MODULES}
    CONFIGURE_COMMAND ${in_source_folder} --preset page
    BUILD_COMMAND ${in_source_folder} --build --preset page --parallel 2 --target playback --target sketch
    BUILD_ALWAYS ON
    BUILD_BYPRODUCTS ${built}
    INSTALL_COMMAND "")

  find_library(RIBBON_LIBDEFLATE deflate REQUIRED)
  add_executable(bundle_page cmake/bundle_page.cpp recorder/page/packed.cpp)
  target_include_directories(bundle_page PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(bundle_page
    PRIVATE ribbon_page ribbon_files ribbon_commandline ${RIBBON_LIBDEFLATE})
  ribbon_precompiled(bundle_page)
endif()

# ribbon_embedded_page(SOURCE FOLDER MODULE): page.html of FOLDER, bundled with what it names there, in
# libribbon/page and beside MODULE (both of the build), becomes part of the tool that SOURCE belongs to.
function(ribbon_embedded_page source folder module)
  if(NOT RIBBON_BUILD_PAGE)
    return()
  endif()
  get_filename_component(name ${module} NAME)
  set(page ${CMAKE_CURRENT_BINARY_DIR}/${name}.html)
  set(shared ${PROJECT_SOURCE_DIR}/libribbon/page)
  set(beside ${CMAKE_CURRENT_BINARY_DIR}/page)
  cmake_path(GET module PARENT_PATH module_folder)
  file(GLOB texts CONFIGURE_DEPENDS ${folder}/*.html ${folder}/*.css ${folder}/*.js
       ${shared}/*.html ${shared}/*.css ${shared}/*.js)
  add_custom_command(
    OUTPUT ${page}
    COMMAND bundle_page ${folder}/page.html ${page} ${folder} ${shared}
            ${RIBBON_PAGE_MODULES}/${module_folder} ${beside}
    DEPENDS bundle_page page_modules ${RIBBON_PAGE_MODULES}/${module}.js
            ${RIBBON_PAGE_MODULES}/${module}.wasm ${texts} ${ARGN})
  set_source_files_properties(${source} PROPERTIES
    COMPILE_DEFINITIONS RIBBON_EMBEDDED_PAGE="${page}"
    OBJECT_DEPENDS ${page})
endfunction()
