# Writes BINARY_FOLDER/tidy/compile_commands.json: how sources are compiled, without the headers that
# are compiled once for all (cmake/DipwrightPrecompiled.cmake), which no other compiler can read.
file(READ ${BINARY_FOLDER}/compile_commands.json commands)
string(REGEX REPLACE "-Winvalid-pch +-include [^ ]*cmake_pch\\.hxx" "" commands "${commands}")
file(WRITE ${BINARY_FOLDER}/tidy/compile_commands.json "${commands}")
