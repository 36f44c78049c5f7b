# Adapts the installed tree to Debian's rules before cpack packs it. Compresses the manual pages and writes
# the changes in Debian's format, with the date of the newest release in CHANGELOG.md. The output is the
# same bytes every time.
if(NOT CPACK_GENERATOR STREQUAL "DEB")
    return()
endif()
set(share ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr/share)

function(dipwright_compress file)
    execute_process(COMMAND gzip --best --no-name --force ${file} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(GLOB pages ${share}/man/man1/*.1)
foreach(page IN LISTS pages)
    dipwright_compress(${page})
endforeach()

set(documents ${share}/doc/dipwright)
set(ours CHANGELOG.md)
set(changes ${documents}/changelog)
file(STRINGS ${documents}/${ours} releases ENCODING UTF-8
    REGEX "^## [0-9.]+ — [0-9-]+$")
list(GET releases 0 newest)
string(REGEX REPLACE "^## ([0-9.]+) — ([0-9-]+)$" "\\1;\\2" newest "${newest}")
list(GET newest 0 version)
list(GET newest 1 day)
execute_process(COMMAND date --utc --rfc-email --date=${day} OUTPUT_VARIABLE date
    OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
file(WRITE ${changes} "dipwright (${version}) stable; urgency=medium

  * Release ${version}; what is new is in CHANGELOG.md.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
dipwright_compress(${changes})
