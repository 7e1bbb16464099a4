// From the body of a thread to a kernel: its __global__ entry, its start and its loop on the host.
//
// Included by .cu files only. A body is a struct with a static GLINT_HD run(launch, element).
#pragma once

#include <cuda_runtime.h>

#include "cuda/kernel.h"
#include "engine/base/host_device.h"
#include "engine/kernels/features.h"

namespace glint::cuda_kernels {

constexpr uint32_t kBlockThreads = 128;

/// A bit that is no feature. It gives every kernel function compiled here a name of its own, so that the
/// linker takes neither the CPU's copies for these nor these for the CPU's.
constexpr FeatureMask kCompiledForGpu = FeatureMask{1} << 62;
static_assert((kAllFeatures & kCompiledForGpu) == 0);

template <class Body, class Launch>
__global__ void __launch_bounds__(kBlockThreads) kernel(const __grid_constant__ Launch launch) {
    const uint32_t index = blockIdx.x * kBlockThreads + threadIdx.x;
    if (index < launch.count) { Body::run(launch, launch.first + index); }
}

template <class Body, class Launch>
int startOnGpu(const void* arguments, GpuStream stream) {
    const Launch& launch = *static_cast<const Launch*>(arguments);
    const uint32_t blocks = (launch.count + kBlockThreads - 1) / kBlockThreads;
    kernel<Body><<<blocks, kBlockThreads, 0, static_cast<cudaStream_t>(stream)>>>(launch);
    return cudaGetLastError();
}

template <class Body, class Launch>
void runOnHost(const void* arguments, uint32_t begin, uint32_t end) {
    const Launch& launch = *static_cast<const Launch*>(arguments);
    for (uint32_t index = begin; index < end; ++index) {
        Body::run(launch, launch.first + index);
    }
}

template <class Body, class Launch>
constexpr Kernel<Launch> makeKernel(const char* step, const char* variant = "") {
    return {{step, variant, startOnGpu<Body, Launch>, runOnHost<Body, Launch>}};
}

}  // namespace glint::cuda_kernels
