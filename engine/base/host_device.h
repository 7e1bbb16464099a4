// The one place that knows which compiler reads a kernel header.
//
// Functions marked GLINT_HD run on the host and, compiled by nvcc, on the device. They use no
// exceptions, no allocation, no virtual calls and no std:: containers. GLINT_ON_DEVICE is 1 only while
// device code is generated.
#pragma once

#if defined(__CUDACC__)
#define GLINT_HD __host__ __device__
#define GLINT_ONCE_ON_HOST(...)
#else
#define GLINT_HD
/// An instance of a template that one source file makes for all kernels of the host; nvcc makes its own.
#define GLINT_ONCE_ON_HOST(...) extern __VA_ARGS__
#endif

#if defined(__CUDA_ARCH__)
#define GLINT_ON_DEVICE 1
#else
#define GLINT_ON_DEVICE 0
#endif
