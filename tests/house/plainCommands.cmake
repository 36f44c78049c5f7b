# Writes BINARY_FOLDER/tidy/compile_commands.json: the compile commands without precompiled headers
# (cmake/DipwrightPrecompiled.cmake). Other compilers cannot read these headers.
file(READ ${BINARY_FOLDER}/compile_commands.json commands)
string(REGEX REPLACE "-Winvalid-pch +-include [^ ]*cmake_pch\\.hxx" "" commands "${commands}")
file(WRITE ${BINARY_FOLDER}/tidy/compile_commands.json "${commands}")
