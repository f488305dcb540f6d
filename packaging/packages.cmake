# Debian packages, by cpack in a build folder.
set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL tools development)
if(RIBBON_BUILD_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()

set(CPACK_DEBIAN_TOOLS_PACKAGE_NAME ribbon)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libribbon-dev)
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-ribbon)

# Whoever publishes the packages answers for them, by the variables that Debian's own tools read. The project itself has
# no public address: .invalid is the domain of those that are none (RFC 2606).
set(maintainer_name "The ribbon authors")
set(maintainer_address authors@ribbon.invalid)
if(NOT "$ENV{DEBFULLNAME}" STREQUAL "" AND NOT "$ENV{DEBEMAIL}" STREQUAL "")
  set(maintainer_name "$ENV{DEBFULLNAME}")
  set(maintainer_address "$ENV{DEBEMAIL}")
endif()
set(CPACK_PACKAGE_CONTACT "${maintainer_name} <${maintainer_address}>")
configure_file(changelog.in ${CMAKE_CURRENT_BINARY_DIR}/changelog @ONLY)

# What every package must have.
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} upper)
  set(documents_of_package ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  install(FILES copyright DESTINATION ${documents_of_package} COMPONENT ${component})
  install_compressed(${component} ${CMAKE_CURRENT_BINARY_DIR}/changelog ${documents_of_package} changelog.Debian)
endforeach()

set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)

set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # otherwise it goes before that of each package
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_TOOLS_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_TOOLS_DESCRIPTION "simulates how a band of cloth is fastened
Fastens a band of cloth (a kimono sash, a cravat, a gift ribbon) around an
object, records it frame by frame, replays it as ray-traced pictures and
exports it to modelling packages. A knot is drawn as a flat curve and drawn
tight without passing through itself or the object.")
# Loaded when they are needed, and told by name where they are missing.
set(CPACK_DEBIAN_TOOLS_PACKAGE_RECOMMENDS libosmesa6)
set(CPACK_DEBIAN_TOOLS_PACKAGE_SUGGESTS "ffmpeg, bash-completion, blender")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "libdeflate-dev, libeigen3-dev, libexpected-dev, libfmt-dev, libtbb-dev, libzstd-dev")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "recordings of bands of cloth in programs of one's own
Headers and static libraries that read recordings of ribbon, also while they
are written, verify that nothing intersects in them, and write them.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.11), python3 (<< 3.12), python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_SOURCE_DIR}/postinst
    ${CMAKE_CURRENT_SOURCE_DIR}/prerm)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-matplotlib, blender")
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "recordings of bands of cloth in Python
Reads recordings of ribbon as arrays of NumPy, also while they are written,
verifies that nothing intersects in them, and writes them.")

include(CPack)
