# find_package(Dipwright): the interface that solvers are written against, a header without a library.
include(${CMAKE_CURRENT_LIST_DIR}/DipwrightTargets.cmake)
