# Packs the installed tree when `cpack` runs in the build folder (scripts/package). On Linux it makes a
# tarball with all libraries, which can be unpacked anywhere, and a Debian package; elsewhere an archive.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON) # packs what is built, and builds no tests for it
set(CPACK_PACKAGE_NAME dipwright)
set(CPACK_PACKAGE_VENDOR Dipwright)
# A package for Debian names a person's address; .invalid is nobody's, until whoever publishes one says his.
set(DIPWRIGHT_CONTACT "The Dipwright maintainers <maintainers@dipwright.invalid>" CACHE STRING
    "Who answers for the packages, as Name <address>")
set(CPACK_PACKAGE_CONTACT ${DIPWRIGHT_CONTACT})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "computational hydrographic printing")
set(CPACK_PACKAGE_DESCRIPTION "Computes from a textured model the sheet that has to be printed on a film, so
that the film, laid on water and dipped through, puts the texture where it
belongs. With a window, and a command line that needs none.")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_CHECKSUM SHA256)
string(TOLOWER ${CMAKE_SYSTEM_NAME} system)
set(CPACK_PACKAGE_FILE_NAME dipwright-${PROJECT_VERSION}-${system}-${CMAKE_SYSTEM_PROCESSOR})
if(WIN32)
    set(CPACK_GENERATOR ZIP)
else()
    set(CPACK_GENERATOR TGZ)
endif()

if(CMAKE_SYSTEM_NAME STREQUAL "Linux")
    list(APPEND CPACK_GENERATOR DEB)
    set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
    set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
    # dpkg-shlibdeps finds the linked libraries. Not linked: Qt loads the readers of TIFF and WebP and the
    # fonts at run time.
    set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
    set(CPACK_DEBIAN_PACKAGE_DEPENDS "qt6-image-formats-plugins, fonts-dejavu-core")
    set(CPACK_DEBIAN_PACKAGE_RECOMMENDS
        "shared-mime-info, desktop-file-utils, qt6-translations-l10n, cups, libgl1-mesa-dri, python3-numpy")
    install(FILES ${PROJECT_SOURCE_DIR}/resources/desktop/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR})
    set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/resources/desktop/prerm)
    set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION TRUE)
    set(CPACK_PRE_BUILD_SCRIPTS
        ${PROJECT_SOURCE_DIR}/cmake/DebianFiles.cmake ${PROJECT_SOURCE_DIR}/cmake/BundledLibraries.cmake)
    # BundledLibraries.cmake reads these.
    get_target_property(qtpaths Qt6::qtpaths IMPORTED_LOCATION)
    foreach(kind PLUGINS TRANSLATIONS)
        execute_process(COMMAND ${qtpaths} --query QT_INSTALL_${kind}
            OUTPUT_VARIABLE CPACK_DIPWRIGHT_QT_${kind} OUTPUT_STRIP_TRAILING_WHITESPACE
            COMMAND_ERROR_IS_FATAL ANY)
    endforeach()
endif()
include(CPack)
