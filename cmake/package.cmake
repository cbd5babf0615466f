# `cpack -G DEB` in the build folder, after a build: a package for the Debian that it was built on.
set(CPACK_PACKAGE_NAME mien)
set(CPACK_PACKAGE_CONTACT "The mien authors <authors@mien.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_DESCRIPTION "One YAML file describes a head and a performance. mien draws the
head for every frame, has POV-Ray render the clip, and writes OpenSCAD
busts to print.")
set(CPACK_GENERATOR DEB)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PRE_BUILD_SCRIPTS "${CMAKE_CURRENT_LIST_DIR}/debian_places.cmake")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
# The libraries' packages and versions are read from the program; what it runs is named here.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "povray, ffmpeg")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "openscad, libjs-three, libjs-codemirror, xdg-utils")
include(CPack)
