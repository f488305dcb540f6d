# What other programs build upon (docs/library.md): the stations that read, verify and write recordings,
# with their headers, as a CMake package. Libraries of headers alone that only our sources include are not
# asked for there.
include(CMakePackageConfigHelpers)

set(installed_headers ${CMAKE_INSTALL_INCLUDEDIR}/ribbon)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/ribbon)

foreach(station result text files parallel exact geometry verification knot recording playback inspection)
  set_target_properties(ribbon_${station} PROPERTIES EXPORT_NAME ${station})
  install(TARGETS ribbon_${station} EXPORT ribbon-targets COMPONENT development
          INCLUDES DESTINATION ${installed_headers})
  install(DIRECTORY ${station} DESTINATION ${installed_headers} COMPONENT development
          FILES_MATCHING PATTERN "*.h")
endforeach()

# Matrices cross the border: whoever compiles for newer processors must align them as the library does.
target_compile_definitions(ribbon_geometry INTERFACE $<INSTALL_INTERFACE:EIGEN_MAX_ALIGN_BYTES=16>)

configure_package_config_file(ribbon-config.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/ribbon-config.cmake
                              INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/ribbon-config-version.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/ribbon-config.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/ribbon-config-version.cmake
        DESTINATION ${package_folder} COMPONENT development)
install(EXPORT ribbon-targets NAMESPACE ribbon:: DESTINATION ${package_folder} COMPONENT development)
