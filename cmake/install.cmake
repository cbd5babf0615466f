# Where everything goes: `cmake --install build --prefix X`. src/core/data.cpp finds the data from the program.

# The manual page and the completions, which a program writes from the tables of commands and options.
add_executable(mien_pages src/mien_pages.cpp)
target_link_libraries(mien_pages PRIVATE mien_core)
set(MIEN_PAGES "${CMAKE_CURRENT_BINARY_DIR}/pages")
add_custom_command(OUTPUT "${MIEN_PAGES}/written"
                   COMMAND mien_pages "${MIEN_PAGES}"
                   COMMAND ${CMAKE_COMMAND} -E touch "${MIEN_PAGES}/written"
                   DEPENDS mien_pages VERBATIM)
add_custom_target(mien_documents ALL DEPENDS "${MIEN_PAGES}/written")

# What is installed has been built before: neither the tests nor the bench are built for it.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)
install(TARGETS mien RUNTIME)
if(ESPEAK_FOUND)
  install(TARGETS mien-speak RUNTIME)
endif()
install(DIRECTORY templates configs DESTINATION "${CMAKE_INSTALL_DATADIR}/mien")
install(FILES "${MIEN_PAGES}/mien.1" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1")
install(FILES "${MIEN_PAGES}/mien.bash" RENAME mien DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions")
install(FILES "${MIEN_PAGES}/_mien" DESTINATION "${CMAKE_INSTALL_DATADIR}/zsh/site-functions")
install(FILES "${MIEN_PAGES}/mien.fish" DESTINATION "${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d")
install(FILES README.md CHANGELOG.md CONTRIBUTING.md LICENSE NOTICE DESTINATION "${CMAKE_INSTALL_DOCDIR}")
# The manual that the README leads to, with its pictures.
install(DIRECTORY docs DESTINATION "${CMAKE_INSTALL_DOCDIR}"
        PATTERN make_pictures EXCLUDE PATTERN draw_cage.awk EXCLUDE PATTERN live_picture.py EXCLUDE)
