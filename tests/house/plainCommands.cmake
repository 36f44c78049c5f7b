# Writes BINARY_FOLDER/tidy/compile_commands.json: the compile commands without precompiled headers
# (cmake/DipwrightPrecompiled.cmake), which no other compiler can read.
file(READ ${BINARY_FOLDER}/compile_commands.json commands)
string(REGEX REPLACE "-Winvalid-pch +-include [^ ]*cmake_pch\\.hxx" "" commands "${commands}")
file(WRITE ${BINARY_FOLDER}/tidy/compile_commands.json "${commands}")
