# ribbon_page_module(NAME EXPORTS FUNCTION...): NAME, an executable, becomes what a page's worker calls:
# the C functions, without main, so that what has been opened stays open between calls. A page has no
# threads, but memory that grows with what is put into it.
function(ribbon_page_module name)
  cmake_parse_arguments(module "" "" "EXPORTS" ${ARGN})
  list(TRANSFORM module_EXPORTS PREPEND "_")
  list(JOIN module_EXPORTS "," exported)
  target_link_options(${name} PRIVATE
    --no-entry -sENVIRONMENT=worker,node -sMODULARIZE=1 -sEXPORT_NAME=createLibrary
    -sALLOW_MEMORY_GROWTH=1 -sTOTAL_STACK=1MB -sEXPORTED_FUNCTIONS=_malloc,_free,${exported}
    -sEXPORTED_RUNTIME_METHODS=FS,UTF8ToString,stringToUTF8)
endfunction()
