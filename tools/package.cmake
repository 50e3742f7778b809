# Rules of `cmake --install`. The installed folder can be moved, because the program finds share/simreel relative to its
# own folder and contains its shaders. `cpack` in the build folder makes a .deb.
include(GNUInstallDirs)
install(TARGETS simreel)
install(DIRECTORY glsl DESTINATION ${CMAKE_INSTALL_DATADIR}/simreel)
install(DIRECTORY assets DESTINATION ${CMAKE_INSTALL_DATADIR}/simreel PATTERN gallery EXCLUDE
        PATTERN golden EXCLUDE PATTERN guide EXCLUDE)
# Installs the guide, cookbook and reference, with their pictures.
install(DIRECTORY assets/guide DESTINATION ${CMAKE_INSTALL_DOCDIR})

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "simreel <simreel@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "renderer of GPU simulations that needs no display")
set(CPACK_PACKAGE_DESCRIPTION "Steps simulations in OpenGL 4.5 compute shaders and writes pictures or a video,
the same from run to run, on a GPU or on Mesa's software driver.")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
# dpkg-shlibdeps finds the linked libraries. The listed packages are those that libepoxy and libglvnd load by name at
# run time.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libegl1, libopengl0 | libgl1, libegl-mesa0, libgl1-mesa-dri")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS ffmpeg)
include(CPack)
