# find_package(Dipwright): provides the solver interface, a header without a library.
include(${CMAKE_CURRENT_LIST_DIR}/DipwrightTargets.cmake)
