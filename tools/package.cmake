# Rules of `cmake --install`. The installed tree can be moved, because the program finds share/simreel relative to its
# own file and contains the shaders. `cpack` in the build folder makes four .deb packages: the program with the assets,
# the library, its headers, and the Python module.
include(GNUInstallDirs)
install(TARGETS simreel)
install(DIRECTORY glsl DESTINATION ${CMAKE_INSTALL_DATADIR}/simreel)
install(DIRECTORY assets DESTINATION ${CMAKE_INSTALL_DATADIR}/simreel PATTERN gallery EXCLUDE
        PATTERN golden EXCLUDE PATTERN guide EXCLUDE)
# Installs the guide, cookbook and reference, with their pictures.
install(DIRECTORY assets/guide DESTINATION ${CMAKE_INSTALL_DOCDIR})

if(TARGET simreel_python)
  math(EXPR NEXT_PYTHON "${Python_VERSION_MINOR} + 1")
endif()
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "simreel <simreel@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "renderer of GPU simulations that needs no display")
set(CPACK_PACKAGE_DESCRIPTION "Steps simulations in OpenGL 4.5 compute shaders and writes pictures or a video,
the same from run to run, on a GPU or on Mesa's software driver.")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
# dpkg-shlibdeps finds the linked libraries. libepoxy and libglvnd also load libraries by name at run time; their
# packages are listed here.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libegl1, libopengl0 | libgl1, libegl-mesa0, libgl1-mesa-dri")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS ffmpeg)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENTS_ALL program library development)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME simreel)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libsimreel)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "simreel (= ${PROJECT_VERSION}), ${CPACK_DEBIAN_PACKAGE_DEPENDS}")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libsimreel-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libsimreel (= ${PROJECT_VERSION})")
if(TARGET simreel_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-simreel)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "libsimreel (= ${PROJECT_VERSION}), python3-numpy, python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}), python3 (<< ${Python_VERSION_MAJOR}.${NEXT_PYTHON})")
endif()
# dpkg-shlibdeps must find libsimreel in the build folder, because no installed package contains it.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_BINARY_DIR})
include(CPack)
