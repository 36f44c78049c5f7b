# Defines the folders of an installed tree, below any prefix:
#   cmake --install build/release --prefix …
# Programs find the other folders from their own location (core/base/ShippedFolders), so the tree can be
# moved. Profiles, translations, guide and pictures are inside the programs.
if(NOT CMAKE_INSTALL_DOCDIR)
    set(CMAKE_INSTALL_DOCDIR share/doc/dipwright)
endif()
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(DIPWRIGHT_PLUGIN_DESTINATION ${CMAKE_INSTALL_LIBDIR}/dipwright/plugins)
# Programs that only Dipwright's programs start.
set(DIPWRIGHT_HELPER_DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/dipwright)
set(DIPWRIGHT_SAMPLE_DESTINATION ${CMAKE_INSTALL_DATADIR}/dipwright/samples)
# Where Debian's Python looks for modules, below /usr; elsewhere, name the folder in PYTHONPATH.
set(DIPWRIGHT_PYTHON_DESTINATION lib/python3/dist-packages)
set(DIPWRIGHT_PACKAGE_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Dipwright)
file(RELATIVE_PATH DIPWRIGHT_PLUGINS_FROM_PROGRAM
    ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR}/dipwright/plugins)
file(RELATIVE_PATH DIPWRIGHT_HELPERS_FROM_PROGRAM
    ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBEXECDIR}/dipwright)
file(RELATIVE_PATH DIPWRIGHT_SAMPLES_FROM_PROGRAM
    ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_DATADIR}/dipwright/samples)

# Dipwright has no shared libraries. Other libraries outside the system's folders are searched where they
# were during the build.
set(CMAKE_INSTALL_RPATH_USE_LINK_PATH ON)

# dipwright_install_package(TARGET HEADER …)
#   Installs what a separate solver needs: find_package(Dipwright) provides Dipwright::SolverInterface, from
#   an installed tree or from the build folder.
function(dipwright_install_package target)
    set(package ${PROJECT_BINARY_DIR}/lib/cmake/Dipwright)
    configure_file(${PROJECT_SOURCE_DIR}/cmake/DipwrightConfig.cmake ${package}/DipwrightConfig.cmake
        COPYONLY)
    write_basic_package_version_file(${package}/DipwrightConfigVersion.cmake
        COMPATIBILITY SameMajorVersion ARCH_INDEPENDENT)
    install(TARGETS ${target} EXPORT DipwrightTargets)
    install(FILES ${ARGN} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/dipwright)
    install(EXPORT DipwrightTargets NAMESPACE Dipwright:: DESTINATION ${DIPWRIGHT_PACKAGE_DESTINATION})
    install(FILES ${package}/DipwrightConfig.cmake ${package}/DipwrightConfigVersion.cmake
        DESTINATION ${DIPWRIGHT_PACKAGE_DESTINATION})
    export(EXPORT DipwrightTargets NAMESPACE Dipwright:: FILE ${package}/DipwrightTargets.cmake)
endfunction()
