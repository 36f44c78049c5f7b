# Sets DIPWRIGHT_HAS_CUDA where the CUDA plugin can be built, and enables the language then.

set(DIPWRIGHT_HAS_CUDA OFF)
if(DIPWRIGHT_SANITIZE)
    message(STATUS "CUDA plugin: left out of builds with sanitizers")
elseif(DIPWRIGHT_CUDA)
    include(CheckLanguage)
    check_language(CUDA)
    if(CMAKE_CUDA_COMPILER)
        # Turing to Blackwell, and PTX for what comes after.
        set(CMAKE_CUDA_ARCHITECTURES 75-real 80-real 86-real 89-real 90-real 100-real 120 CACHE STRING
            "GPU architectures of the CUDA plugin")
        enable_language(CUDA)
        if(NOT CMAKE_CUDA20_STANDARD_COMPILE_OPTION) # CMake 3.25 does not know that it speaks C++20
            set(CMAKE_CUDA20_STANDARD_COMPILE_OPTION -std=c++20)
        endif()
        find_package(CUDAToolkit REQUIRED)
        set(DIPWRIGHT_HAS_CUDA ON)
        message(STATUS "CUDA plugin: built with CUDA ${CUDAToolkit_VERSION}")
    else()
        message(STATUS "CUDA plugin: left out, there is no CUDA compiler (nvcc)")
    endif()
else()
    message(STATUS "CUDA plugin: left out (DIPWRIGHT_CUDA is off)")
endif()
