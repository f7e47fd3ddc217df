# Installation by `cmake --install`, and the Debian package that `cpack` makes from it.
set(CMAKE_INSTALL_DOCDIR share/doc/beadswim)
include(GNUInstallDirs)

set(programs layout run theory compare optimise plot view bench)
add_custom_target(programs)  # builds all programs without the tests
foreach(program ${programs})
  add_dependencies(programs beadswim-${program})
  install(TARGETS beadswim-${program} RUNTIME)
  # Bash finds the completion file of a program by the name of the program, so each program gets a copy of the file.
  install(FILES ${PROJECT_SOURCE_DIR}/tools/completion/beadswim.bash
          DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME beadswim-${program})
endforeach()

install(FILES LICENSE README.md CHANGELOG.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs PATTERN results EXCLUDE PATTERN generate.py EXCLUDE)
install(FILES docs/results/steps-and-errors.md DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs/results)
install(DIRECTORY schemas packaging DESTINATION ${CMAKE_INSTALL_DOCDIR})  # the installed pages link to these folders
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DOCDIR} USE_SOURCE_PERMISSIONS)
install(DIRECTORY schemas DESTINATION ${CMAKE_INSTALL_DATADIR}/beadswim)

# Installs the libraries for use with find_package(Beadswim); examples/library is an example of such a use.
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Beadswim)
install(EXPORT BeadswimTargets NAMESPACE Beadswim:: DESTINATION ${package_folder} COMPONENT development)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/BeadswimConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES cmake/BeadswimConfig.cmake cmake/BeadswimDependencies.cmake ${CMAKE_BINARY_DIR}/BeadswimConfigVersion.cmake
        DESTINATION ${package_folder} COMPONENT development)

# Makes the manual pages from the help texts of the programs.
find_program(HELP2MAN help2man)
set(name_of_layout "make, vary, disturb, reduce and check layouts of bead-spring microswimmers")
set(name_of_run "run a layout of bead-spring microswimmers in a viscous fluid")
set(name_of_theory "predict velocity and stroke of a bead-spring microswimmer")
set(name_of_compare "compare runs of microswimmers with predictions or other runs")
set(name_of_optimise "search the best values of a layout of bead-spring microswimmers")
set(name_of_plot "draw runs, predictions and trajectories of microswimmers")
set(name_of_view "write a trajectory of microswimmers as a web page of one file")
set(name_of_bench "measure the speed of Beadswim's solvers on this machine")
if(HELP2MAN AND NOT BEADSWIM_SANITIZE)
  foreach(program ${programs})
    set(page ${CMAKE_BINARY_DIR}/man/beadswim-${program}.1)
    set(help --help)
    if(program MATCHES "layout|plot")
      set(help --help-all)  # with the flags of all subcommands
    endif()
    add_custom_command(
      OUTPUT ${page}
      COMMAND ${CMAKE_COMMAND} -E env OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 LC_ALL=C.UTF-8
              ${HELP2MAN} --no-info --help-option=${help} --locale=C.UTF-8 --output=${page} --include=${PROJECT_SOURCE_DIR}/cmake/man.h2m
              --version-string=${PROJECT_VERSION} --name=${name_of_${program}} $<TARGET_FILE:beadswim-${program}>
      DEPENDS beadswim-${program} ${PROJECT_SOURCE_DIR}/cmake/man.h2m
      VERBATIM)
    list(APPEND pages ${page})
  endforeach()
  file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/man)
  add_custom_target(manual_pages ALL DEPENDS ${pages})
  install(FILES ${pages} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
else()
  message(STATUS "No manual pages: help2man is not there, or the build is for tests")
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "Beadswim developers <beadswim@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL Unspecified)      # programs and documents; the libraries are installed only by cmake --install
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_NAME beadswim)
set(CPACK_DEBIAN_UNSPECIFIED_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)                       # adds the linked libraries to the dependencies
set(CPACK_DEBIAN_PACKAGE_DEPENDS openmpi-bin)                # Open MPI starts its daemon even for a run on one rank
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "librsvg2-bin, jq")      # PNG figures; commands in the documentation
include(CPack)
