// The one place that knows which compiler reads a kernel header.
//
// Functions marked GLINT_HD run on the host and, compiled by nvcc, on the device. They use no
// exceptions, no allocation, no virtual calls and no std:: containers. GLINT_ON_DEVICE is 1 only while
// device code is generated.
#pragma once

#if defined(__CUDACC__)
#define GLINT_HD __host__ __device__
#else
#define GLINT_HD
#endif

#if defined(__CUDA_ARCH__)
#define GLINT_ON_DEVICE 1
#else
#define GLINT_ON_DEVICE 0
#endif
