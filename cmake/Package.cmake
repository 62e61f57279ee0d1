# Debian packages, made by scripts/package.sh: springcheck, and libspringcheck-dev.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME springcheck)
set(CPACK_PACKAGE_CONTACT "The springcheck maintainers <maintainers@springcheck.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY
  "compares mass-spring models of soft tissue with finite elements")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME springcheck)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "python3, python3-h5py, python3-jinja2, \
python3-matplotlib, python3-meshio, python3-numpy, python3-pandas, python3-plotly")
# Python's compiled files come and go with the package.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/cmake/debian/postinst
  ${PROJECT_SOURCE_DIR}/cmake/debian/prerm)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION
"Runs mass-spring models and finite elements on the same meshes, and reports
how far they are apart: volume error, point deviation, plate force, torque.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libspringcheck-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libboost-dev, libdeal.ii-dev, libeigen3-dev, \
libfmt-dev, libgmsh-dev, libopenblas-pthread-dev, libspdlog-dev, libssl-dev, \
libsuitesparse-dev, libtbb-dev")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION
"Meshes, spring models, finite elements and tissue as static libraries with
their headers, found by CMake as springcheck.")

# What Debian's policy wants to be in a package's folder of documents.
set(changelog ${CMAKE_BINARY_DIR}/debian/changelog)
configure_file(cmake/debian/changelog.in ${changelog} @ONLY)
execute_process(COMMAND gzip -9nf ${changelog} COMMAND_ERROR_IS_FATAL ANY)
foreach(component_and_name "program;springcheck" "development;libspringcheck-dev")
  list(GET component_and_name 0 component)
  list(GET component_and_name 1 name)
  install(FILES cmake/debian/copyright ${changelog}.gz DESTINATION share/doc/${name}
    COMPONENT ${component})
endforeach()
include(CPack)
