# Puts into the tarball what its programs need besides the system: libraries, Qt's plugins and translations,
# a font, and the licences of all of these. Left to the system are glibc and GCC's libraries, which Debian 12
# or later always has, and the drivers of the graphics hardware.
if(NOT CPACK_GENERATOR STREQUAL "TGZ" OR NOT CPACK_DIPWRIGHT_QT_PLUGINS)
    return()
endif()
file(GLOB tree ${CPACK_TEMPORARY_INSTALL_DIRECTORY})
set(bundle ${tree}/lib/dipwright/system)
find_program(PATCHELF patchelf REQUIRED)

# Qt's plugins that the programs use, and where Qt finds them (qt.conf beside each program).
file(GLOB plugins RELATIVE ${CPACK_DIPWRIGHT_QT_PLUGINS} ${CPACK_DIPWRIGHT_QT_PLUGINS}/*/*.so)
list(FILTER plugins INCLUDE REGEX "^(platforms/libq(offscreen|xcb)|iconengines|imageformats|platforminputcontexts|\
printsupport|tls|xcbglintegrations)")
foreach(plugin IN LISTS plugins)
    get_filename_component(kind ${plugin} DIRECTORY)
    file(COPY ${CPACK_DIPWRIGHT_QT_PLUGINS}/${plugin} DESTINATION ${bundle}/plugins/${kind})
endforeach()
list(TRANSFORM plugins PREPEND ${CPACK_DIPWRIGHT_QT_PLUGINS}/)
file(GLOB translations ${CPACK_DIPWRIGHT_QT_TRANSLATIONS}/qtbase_*.qm)
file(COPY ${translations} DESTINATION ${bundle}/translations)
foreach(programs bin libexec/dipwright)
    file(RELATIVE_PATH prefix ${tree}/${programs} ${bundle})
    file(WRITE ${tree}/${programs}/qt.conf
        "[Paths]\nPrefix=${prefix}\nPlugins=plugins\nTranslations=translations\n")
endforeach()

# Fonts for a system without any: core/base/ShippedFolders.h.
set(fonts DejaVuSans.ttf DejaVuSans-Bold.ttf DejaVuSansMono.ttf)
list(TRANSFORM fonts PREPEND /usr/share/fonts/truetype/dejavu/)
file(COPY ${fonts} DESTINATION ${bundle}/fonts)
file(WRITE ${bundle}/fonts/fonts.conf "<?xml version=\"1.0\"?>
<!DOCTYPE fontconfig SYSTEM \"fonts.dtd\">
<fontconfig>
  <dir prefix=\"relative\">.</dir>
  <cachedir prefix=\"xdg\">fontconfig</cachedir>
</fontconfig>
")

# Copies the libraries, and lets every program and module search them first.
file(GLOB programs ${tree}/bin/dipwright* ${tree}/libexec/dipwright/dipwright*)
file(GLOB_RECURSE modules ${tree}/lib/*.so)
file(GET_RUNTIME_DEPENDENCIES EXECUTABLES ${programs} MODULES ${modules}
    RESOLVED_DEPENDENCIES_VAR libraries UNRESOLVED_DEPENDENCIES_VAR missing
    PRE_EXCLUDE_REGEXES "^ld-linux" "^lib(c|m|dl|rt|pthread|resolv|util|anl|stdc\\+\\+|gcc_s|cuda)\\.so")
if(missing)
    message(FATAL_ERROR "Libraries that the tarball needs were not found: ${missing}")
endif()
file(COPY ${libraries} DESTINATION ${bundle}/lib FOLLOW_SYMLINK_CHAIN)
file(GLOB_RECURSE copied ${bundle}/lib/*)
foreach(file IN LISTS programs modules copied)
    if(NOT IS_SYMLINK ${file})
        get_filename_component(folder ${file} DIRECTORY)
        file(RELATIVE_PATH origin ${folder} ${bundle}/lib)
        # DT_RPATH, because it also holds for the libraries of the libraries.
        execute_process(COMMAND ${PATCHELF} --force-rpath --set-rpath "$ORIGIN/${origin}" ${file}
            COMMAND_ERROR_IS_FATAL ANY)
    endif()
endforeach()

# The licences, with the packages and versions that the files come from.
set(licences ${tree}/share/doc/dipwright/libraries)
set(packages "")
foreach(file IN LISTS libraries plugins translations fonts)
    file(REAL_PATH ${file} real)
    execute_process(COMMAND dpkg-query --search ${real} ${file}
        OUTPUT_VARIABLE owner ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
    if(NOT owner)
        string(REGEX REPLACE "^/usr" "" merged ${real}) # dpkg may know it from before /lib became /usr/lib
        execute_process(COMMAND dpkg-query --search ${merged}
            OUTPUT_VARIABLE owner OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
    endif()
    string(REGEX REPLACE "[:,].*" "" package "${owner}")
    list(APPEND packages ${package})
endforeach()
list(REMOVE_DUPLICATES packages)
list(SORT packages)
file(WRITE ${licences}/README "The tarball contains files of these packages of Debian 12. Their sources and changes are published by Debian
under the given name and version; NAME.copyright has the licence.\n\n")
foreach(package IN LISTS packages)
    execute_process(COMMAND dpkg-query -W -f=\${source:Package}\ \${source:Version} ${package}
        OUTPUT_VARIABLE source COMMAND_ERROR_IS_FATAL ANY)
    file(APPEND ${licences}/README "${package}: source ${source}\n")
    configure_file(/usr/share/doc/${package}/copyright ${licences}/${package}.copyright COPYONLY)
endforeach()
