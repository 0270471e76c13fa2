# The Debian package: `cpack` in a build of the preset package. scripts/package makes and tests it.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME obby)
set(CPACK_PACKAGE_CONTACT "obby developers <obby@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_PACKAGE_DESCRIPTION
  "Answers solvability queries about 3D obstacle courses: imports a Roblox place file,
 searches for trajectories that keep the constraints of each query, and shows them
 in a table, a picture or an offline page.")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/package)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION games)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)  # the distribution's shared libraries, found by
                                        # dpkg-shlibdeps
include(CPack)
