# Where there is ccache, compilers are started through it. It is told to take paths below the repository
# as relative, so that it finds in one checkout what was compiled in another, and to believe that
# headers compiled once for all (DipwrightPrecompiled) are what their sources say.
find_program(DIPWRIGHT_CCACHE ccache)
if(DIPWRIGHT_CCACHE)
    set(launcher ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_DEPEND=1 CCACHE_NOHASHDIR=1
        CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
        ${DIPWRIGHT_CCACHE})
    foreach(language C CXX CUDA)
        set(CMAKE_${language}_COMPILER_LAUNCHER ${launcher})
    endforeach()
endif()
