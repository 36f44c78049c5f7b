# Provides OpenCV's core and imgproc as the target `dipwright_opencv`. Debian packages each module
# separately, but the CMake file only with all modules. Without that file, the modules are searched by name.
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
