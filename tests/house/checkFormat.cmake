# Fails if clang-format would change a source file.
file(GLOB_RECURSE sources
    ${SOURCE_FOLDER}/parallel/*.h ${SOURCE_FOLDER}/parallel/*.cpp
    ${SOURCE_FOLDER}/app/*.h ${SOURCE_FOLDER}/app/*.cpp
    ${SOURCE_FOLDER}/core/*.h ${SOURCE_FOLDER}/core/*.cpp
    ${SOURCE_FOLDER}/solvers/*.h ${SOURCE_FOLDER}/solvers/*.cpp ${SOURCE_FOLDER}/solvers/*.cu
    ${SOURCE_FOLDER}/plugins/*.h ${SOURCE_FOLDER}/plugins/*.cpp ${SOURCE_FOLDER}/plugins/*.cu
    ${SOURCE_FOLDER}/resources/*.h ${SOURCE_FOLDER}/resources/*.cpp
    ${SOURCE_FOLDER}/docs/*.cpp
    ${SOURCE_FOLDER}/tests/*.h ${SOURCE_FOLDER}/tests/*.cpp)
execute_process(COMMAND ${CLANG_FORMAT} --dry-run -Werror ${sources}
    RESULT_VARIABLE result ERROR_VARIABLE complaints)
if(NOT result EQUAL 0)
    message(NOTICE "${complaints}")
    message(FATAL_ERROR "These files want clang-format -i")
endif()
