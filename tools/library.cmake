# Builds and installs the shared library libsimreel and the Python module.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(SIMREEL_HEADERS ${CMAKE_SOURCE_DIR}/src/api)
# The symbols of the static libraries are not exported, so that they cannot clash with symbols of other libraries.
target_link_options(simreel_api PRIVATE -Wl,--exclude-libs,ALL)
target_include_directories(simreel_api PUBLIC $<BUILD_INTERFACE:${SIMREEL_HEADERS}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_compile_features(simreel_api INTERFACE cxx_std_20)
set_target_properties(simreel_api PROPERTIES OUTPUT_NAME simreel EXPORT_NAME simreel VERSION ${PROJECT_VERSION}
                      SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})

# Installs the files with which CMake and pkg-config find libsimreel. The installed tree can be moved, because both find
# their files relative to themselves.
set(SIMREEL_CMAKE_FOLDER ${CMAKE_INSTALL_LIBDIR}/cmake/simreel)
install(TARGETS simreel_api EXPORT simreel LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library
        NAMELINK_COMPONENT development)
install(DIRECTORY src/api/simreel DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
install(EXPORT simreel NAMESPACE simreel:: FILE simreel-config.cmake DESTINATION ${SIMREEL_CMAKE_FOLDER} COMPONENT development)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/simreel-config-version.cmake COMPATIBILITY SameMinorVersion)
file(RELATIVE_PATH TO_PREFIX /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
string(REGEX REPLACE "/$" "" TO_PREFIX "${TO_PREFIX}")
configure_file(${CMAKE_SOURCE_DIR}/tools/simreel.pc.in ${CMAKE_BINARY_DIR}/simreel.pc @ONLY)
install(FILES ${CMAKE_BINARY_DIR}/simreel-config-version.cmake DESTINATION ${SIMREEL_CMAKE_FOLDER} COMPONENT development)
install(FILES ${CMAKE_BINARY_DIR}/simreel.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)

# Builds the Python module for the Python for which pybind11 is found. The module can be imported from build/python.
set(SIMREEL_PYTHON_FOLDER lib/python3/dist-packages CACHE STRING "Folder of the Python module below the prefix")
find_program(SIMREEL_PYTHON NAMES python3 PATHS /usr/bin NO_DEFAULT_PATH)
find_program(SIMREEL_PYTHON NAMES python3)
set(Python_EXECUTABLE ${SIMREEL_PYTHON})
find_package(Python 3.9 QUIET COMPONENTS Interpreter Development.Module)
find_package(pybind11 2.9 QUIET CONFIG)
if(NOT Python_Development.Module_FOUND OR NOT pybind11_FOUND)
  message(STATUS "The Python module is left out: it needs pybind11-dev and python3-dev")
  return()
endif()
set(MODULE_FOLDER ${CMAKE_BINARY_DIR}/python/simreel)
pybind11_add_module(simreel_python MODULE NO_EXTRAS python/native.cpp)
target_link_libraries(simreel_python PRIVATE simreel_api)
# -O1 takes a third of the compile time and costs no speed, because the module only calls the library. The warnings are
# disabled because of pybind11's headers.
target_compile_options(simreel_python PRIVATE -O1 -Wno-shadow -Wno-pedantic)
file(RELATIVE_PATH TO_LIBRARY /${SIMREEL_PYTHON_FOLDER}/simreel /${CMAKE_INSTALL_LIBDIR})
set_target_properties(simreel_python PROPERTIES OUTPUT_NAME _native LIBRARY_OUTPUT_DIRECTORY ${MODULE_FOLDER}
                      UNITY_BUILD OFF INSTALL_RPATH "$ORIGIN/${TO_LIBRARY}")
file(GLOB MODULE_SOURCES CONFIGURE_DEPENDS RELATIVE ${CMAKE_SOURCE_DIR}/python/simreel python/simreel/*.py python/simreel/*.pyi python/simreel/py.typed)
set(MODULE_COPIES "")
foreach(file ${MODULE_SOURCES})
  add_custom_command(OUTPUT ${MODULE_FOLDER}/${file} DEPENDS ${CMAKE_SOURCE_DIR}/python/simreel/${file} VERBATIM
    COMMAND ${CMAKE_COMMAND} -E copy ${CMAKE_SOURCE_DIR}/python/simreel/${file} ${MODULE_FOLDER}/${file})
  list(APPEND MODULE_COPIES ${MODULE_FOLDER}/${file})
endforeach()
add_custom_command(OUTPUT ${MODULE_FOLDER}/_types.pyi VERBATIM
  DEPENDS ${CMAKE_SOURCE_DIR}/assets/scene.schema.json ${CMAKE_SOURCE_DIR}/tools/python-types
  COMMAND ${Python_EXECUTABLE} ${CMAKE_SOURCE_DIR}/tools/python-types ${CMAKE_SOURCE_DIR}/assets/scene.schema.json ${MODULE_FOLDER}/_types.pyi)
list(APPEND MODULE_COPIES ${MODULE_FOLDER}/_types.pyi)
add_custom_target(simreel_python_files ALL DEPENDS ${MODULE_COPIES})
add_dependencies(simreel_python simreel_python_files)
# pytest finds its plugin by these metadata.
set(METADATA_FOLDER simreel-${PROJECT_VERSION}.dist-info)
file(WRITE ${CMAKE_BINARY_DIR}/python/${METADATA_FOLDER}/METADATA
     "Metadata-Version: 2.1\nName: simreel\nVersion: ${PROJECT_VERSION}\nSummary: GPU simulations as numpy arrays and pictures\n")
file(WRITE ${CMAKE_BINARY_DIR}/python/${METADATA_FOLDER}/entry_points.txt "[pytest11]\nsimreel = simreel.pytest\n")
install(TARGETS simreel_python LIBRARY DESTINATION ${SIMREEL_PYTHON_FOLDER}/simreel COMPONENT python)
install(DIRECTORY python/simreel DESTINATION ${SIMREEL_PYTHON_FOLDER} COMPONENT python FILES_MATCHING PATTERN *.py
        PATTERN *.pyi PATTERN py.typed)
install(FILES ${MODULE_FOLDER}/_types.pyi DESTINATION ${SIMREEL_PYTHON_FOLDER}/simreel COMPONENT python)
install(DIRECTORY ${CMAKE_BINARY_DIR}/python/${METADATA_FOLDER} DESTINATION ${SIMREEL_PYTHON_FOLDER} COMPONENT python)
