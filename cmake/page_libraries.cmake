# What libribbon needs of others, for WebAssembly: headers of Debian's packages, which are the same for
# any machine, and three libraries compiled from Debian's sources (fetched by .ci/setup.sh). Answers
# find_package(), so that the stations ask for their libraries as they always do.
macro(ribbon_page_library method package)
  if("${package}" MATCHES "^(Eigen3|Boost|CLI11|nlohmann_json|tl-expected|tomlplusplus|fmt|zstd|pugixml)$")
    set(${package}_FOUND TRUE)
  endif()
endmacro()
cmake_language(SET_DEPENDENCY_PROVIDER ribbon_page_library SUPPORTED_METHODS FIND_PACKAGE)

enable_language(C)
set(RIBBON_PAGE_SOURCES ${CMAKE_CURRENT_LIST_DIR}/../build/page-sources CACHE PATH
    "Sources of zstd, pugixml and libdeflate")

# headers(TARGET FOLDER...): folders of /usr/include, which as a whole is for another machine.
function(headers target)
  file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/headers)
  foreach(folder IN LISTS ARGN)
    get_filename_component(name ${folder} NAME)
    file(CREATE_LINK /usr/include/${folder} ${CMAKE_BINARY_DIR}/headers/${name} SYMBOLIC)
  endforeach()
  add_library(${target} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${target} SYSTEM INTERFACE ${CMAKE_BINARY_DIR}/headers)
endfunction()

headers(Eigen3::Eigen eigen3/Eigen)
# The preset's -msse2 has Eigen use its SSE packets, of which Emscripten makes instructions of WebAssembly.
# For those of MMX, which nobody uses, it has no header; and it is to pass for a GCC for which Eigen has no
# assembler of x86.
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/headers/mmintrin.h CONTENT "")
headers(Boost::headers boost svgpp exboost)
headers(CLI11::CLI11 CLI)
headers(nlohmann_json::nlohmann_json nlohmann)
headers(tl::expected tl)
headers(tomlplusplus::tomlplusplus toml++)
headers(fmt::fmt fmt)
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)

file(GLOB zstd_sources ${RIBBON_PAGE_SOURCES}/libzstd/lib/common/*.c
     ${RIBBON_PAGE_SOURCES}/libzstd/lib/compress/*.c ${RIBBON_PAGE_SOURCES}/libzstd/lib/decompress/*.c)
add_library(zstd EXCLUDE_FROM_ALL STATIC ${zstd_sources})
# Of two decoders of the same bytes the smaller (zstd's lib/README.md, "Modular build").
target_compile_definitions(zstd PRIVATE ZSTD_DISABLE_ASM HUF_FORCE_DECOMPRESS_X1
                           ZSTD_FORCE_DECOMPRESS_SEQUENCES_SHORT)
target_compile_options(zstd PRIVATE -Oz)
target_include_directories(zstd SYSTEM INTERFACE ${RIBBON_PAGE_SOURCES}/libzstd/lib)
add_library(zstd::libzstd_static ALIAS zstd)

add_library(pugixml EXCLUDE_FROM_ALL STATIC ${RIBBON_PAGE_SOURCES}/pugixml/src/pugixml.cpp)
target_include_directories(pugixml SYSTEM INTERFACE ${RIBBON_PAGE_SOURCES}/pugixml/src)
target_compile_options(pugixml PRIVATE -Oz)
add_library(pugixml::pugixml ALIAS pugixml)

# Of libdeflate recordings need the checksum alone.
add_library(crc32 EXCLUDE_FROM_ALL STATIC ${RIBBON_PAGE_SOURCES}/libdeflate/lib/crc32.c)
target_include_directories(crc32 SYSTEM PUBLIC ${RIBBON_PAGE_SOURCES}/libdeflate)
set(RIBBON_LIBDEFLATE crc32 CACHE STRING "In the place of libdeflate")
