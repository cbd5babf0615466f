# What Debian has elsewhere than the rest of the world, or compressed, put right before the package is made.
set(share "${CPACK_TEMPORARY_INSTALL_DIRECTORY}${CPACK_PACKAGING_INSTALL_PREFIX}/share")
if(CPACK_GENERATOR STREQUAL "DEB")
  file(RENAME "${share}/zsh/site-functions" "${share}/zsh/vendor-completions")
  file(RENAME "${share}/doc/mien/LICENSE" "${share}/doc/mien/copyright")
  file(RENAME "${share}/doc/mien/CHANGELOG.md" "${share}/doc/mien/changelog")
  # Without the time of the file, so that the same sources give the same package.
  execute_process(COMMAND gzip -9n "${share}/man/man1/mien.1" "${share}/doc/mien/changelog" COMMAND_ERROR_IS_FATAL ANY)
endif()
