# Starts compilers through ccache, if it is installed. Paths below the repository count as relative, so that
# one checkout finds the results of another. ccache trusts precompiled headers (DipwrightPrecompiled) to
# match their sources.
find_program(DIPWRIGHT_CCACHE ccache)
if(DIPWRIGHT_CCACHE)
    set(launcher ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_DEPEND=1 CCACHE_NOHASHDIR=1
        CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
        ${DIPWRIGHT_CCACHE})
    foreach(language C CXX CUDA)
        set(CMAKE_${language}_COMPILER_LAUNCHER ${launcher})
    endforeach()
endif()
