# What `cmake --install` puts in place, in two components: the program with the Python
# module that reads its results, and for development the libraries that stand by
# themselves, found by find_package(springcheck).
include(GNUInstallDirs)
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)  # a package needs no test

install(TARGETS springcheck COMPONENT program)
install(TARGETS springcheck_core DESTINATION libexec/springcheck COMPONENT program)
set(SPRINGCHECK_PYTHON_DIR lib/python3/dist-packages CACHE STRING
  "Where the Python module that reads results is installed; of Debian's /usr unless set")
install(FILES reports/springcheck_results.py DESTINATION ${SPRINGCHECK_PYTHON_DIR}
  COMPONENT program)
install(FILES README.md NOTICE reports/springcheck_report/page_licences.txt CITATION.cff
  DESTINATION ${CMAKE_INSTALL_DOCDIR}
  COMPONENT program)
install(DIRECTORY comparisons/shipped/scenes comparisons/shipped/sweeps
  comparisons/shipped/gates DESTINATION ${CMAKE_INSTALL_DATADIR}/springcheck
  COMPONENT program)  # to be read: the program holds them itself
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)

# Manual pages and what shells complete commands by, from the program's own declarations.
install(CODE [[
  set(share "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/share")
  set(executable $<TARGET_FILE:springcheck>)
  foreach(shell_and_file "bash;bash-completion/completions/springcheck"
      "zsh;zsh/vendor-completions/_springcheck"
      "fish;fish/vendor_completions.d/springcheck.fish")
    list(GET shell_and_file 0 shell)
    list(GET shell_and_file 1 file)
    get_filename_component(folder "${share}/${file}" DIRECTORY)
    file(MAKE_DIRECTORY ${folder})
    execute_process(COMMAND ${executable} completion ${shell} OUTPUT_FILE "${share}/${file}"
      COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
  set(pages "${share}/man/man1")
  execute_process(COMMAND ${executable} manual --out "${pages}" COMMAND_ERROR_IS_FATAL ANY)
  file(GLOB pages "${pages}/springcheck*.1")
  execute_process(COMMAND gzip -9nf ${pages} COMMAND_ERROR_IS_FATAL ANY)
]] COMPONENT program)

set(libraries meshing dynamics statics tissue mss fem_reference)
foreach(library ${libraries})
  list(APPEND installed ${rooms_in_${library}})
endforeach()
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/springcheck)
install(TARGETS ${installed} deal.II gmsh cholmod EXPORT springcheck
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}/springcheck COMPONENT development)
install(EXPORT springcheck NAMESPACE springcheck:: FILE springcheckTargets.cmake
  DESTINATION ${package_folder} COMPONENT development)
install(DIRECTORY ${libraries} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/springcheck
  COMPONENT development FILES_MATCHING PATTERN "*.hpp")

include(CMakePackageConfigHelpers)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/springcheckConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES cmake/springcheckConfig.cmake ${CMAKE_BINARY_DIR}/springcheckConfigVersion.cmake
  DESTINATION ${package_folder} COMPONENT development)
