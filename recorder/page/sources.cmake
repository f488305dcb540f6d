# What the page in which one draws calls: built as WebAssembly for the page, natively for tests.
set(sketch_sources
  drawn_diagram.cpp sketch_api.cpp sketched_scene.cpp taken_away.cpp tying.cpp)
list(TRANSFORM sketch_sources PREPEND ${CMAKE_CURRENT_LIST_DIR}/)
