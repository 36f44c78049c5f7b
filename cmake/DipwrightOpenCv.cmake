# OpenCV's core and imgproc as the target `dipwright_opencv`. Debian has each module in a package of its
# own, and the file that tells CMake of them only in the one that brings all: so they are looked for
# by name where that file is missing.
find_package(OpenCV 4.5 QUIET COMPONENTS core imgproc)
add_library(dipwright_opencv INTERFACE)
if(OpenCV_FOUND)
    target_include_directories(dipwright_opencv SYSTEM INTERFACE ${OpenCV_INCLUDE_DIRS})
    target_link_libraries(dipwright_opencv INTERFACE ${OpenCV_LIBS})
else()
    find_path(DIPWRIGHT_OPENCV_HEADERS opencv2/imgproc.hpp PATH_SUFFIXES opencv4 REQUIRED)
    find_library(DIPWRIGHT_OPENCV_CORE opencv_core REQUIRED)
    find_library(DIPWRIGHT_OPENCV_IMGPROC opencv_imgproc REQUIRED)
    target_include_directories(dipwright_opencv SYSTEM INTERFACE ${DIPWRIGHT_OPENCV_HEADERS})
    target_link_libraries(dipwright_opencv
        INTERFACE ${DIPWRIGHT_OPENCV_IMGPROC} ${DIPWRIGHT_OPENCV_CORE})
endif()
