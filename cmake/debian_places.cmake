# What Debian has elsewhere than the rest of the world, moved before the package is made.
set(share "${CPACK_TEMPORARY_INSTALL_DIRECTORY}${CPACK_PACKAGING_INSTALL_PREFIX}/share")
if(CPACK_GENERATOR STREQUAL "DEB")
  file(RENAME "${share}/zsh/site-functions" "${share}/zsh/vendor-completions")
  file(RENAME "${share}/doc/mien/LICENSE" "${share}/doc/mien/copyright")
endif()
