# Decides whether the CUDA back end is built (GLINT_HAS_CUDA) and enables the language when it is.
# Nothing else depends on nvcc: without it the program is the same but for this back end.

set(GLINT_HAS_CUDA 0)
if(GLINT_CUDA STREQUAL "OFF")
    return()
endif()

# WSL has no such device, but the driver's library where the host has a card.
if(GLINT_CUDA STREQUAL "CARD" AND NOT EXISTS /dev/nvidiactl AND NOT EXISTS /usr/lib/wsl/lib/libcuda.so.1)
    message(STATUS "CUDA back end: left out, there is no card")
    return()
endif()

if(NOT CMAKE_CUDA_COMPILER)
    find_program(GLINT_NVCC nvcc HINTS ENV CUDA_PATH ENV CUDA_HOME PATHS /usr/local/cuda PATH_SUFFIXES bin)
    if(GLINT_NVCC)
        set(CMAKE_CUDA_COMPILER ${GLINT_NVCC})
    elseif(GLINT_CUDA MATCHES "^(AUTO|CARD)$")
        message(STATUS "CUDA back end: left out, nvcc was not found")
        return()
    else()
        message(FATAL_ERROR "GLINT_CUDA is ON, but nvcc was not found in PATH, CUDA_PATH or /usr/local/cuda/bin. "
                            "Install the CUDA Toolkit, or configure with -DGLINT_CUDA=OFF.")
    endif()
endif()

# Machine code is made for this machine's card. Where there is none, the assembler's minutes would be for nothing: PTX of
# 7.5 (Turing), the oldest architecture of CUDA 13, is what any card compiles when it loads it.
if(NOT DEFINED CMAKE_CUDA_ARCHITECTURES)
    if(EXISTS /dev/nvidiactl)
        set(CMAKE_CUDA_ARCHITECTURES native)
    else()
        set(CMAKE_CUDA_ARCHITECTURES 75-virtual)
    endif()
endif()
set(CMAKE_CUDA_HOST_COMPILER ${CMAKE_CXX_COMPILER})
set(CMAKE_CUDA_RUNTIME_LIBRARY Static)
enable_language(CUDA)
# CMake 3.25 does not know this dialect of nvcc's.
if(NOT CMAKE_CUDA20_STANDARD_COMPILE_OPTION)
    set(CMAKE_CUDA20_STANDARD_COMPILE_OPTION -std=c++20)
    set(CMAKE_CUDA20_EXTENSION_COMPILE_OPTION -std=c++20)
endif()
find_package(CUDAToolkit REQUIRED)
set(GLINT_HAS_CUDA 1)
message(STATUS "CUDA back end: nvcc ${CMAKE_CUDA_COMPILER_VERSION}")
