// The path kernels for the GPU: what a thread does, its __global__ entry and its loop on the host.
//
// Included by one small .cu file for each variant, and by nothing else. The bodies only find their pixel: all
// that is computed there is in engine/kernels.
#pragma once

#include <cuda_runtime.h>

#include "cuda/cuda_variant.h"
#include "cuda/launch.h"
#include "engine/kernels/aov_kernel.h"
#include "engine/kernels/named_masks.h"
#include "engine/kernels/path_kernel.h"

namespace glint::cuda_kernels {

constexpr uint32_t kBlockThreads = 128;

/// A bit that is no feature. It gives every kernel function compiled here a name of its own, so that the
/// linker takes neither the CPU's copies for these nor these for the CPU's.
constexpr FeatureMask kCompiledForGpu = 1u << 31;
static_assert((kAllFeatures & kCompiledForGpu) == 0);

template <FeatureMask kMask>
GLINT_HD PixelSample traceOne(const PathLaunch& launch, int x, int y) {
    return tracePixel<kMask>(launch.view, launch.params, x, y);
}
template <FeatureMask kMask>
GLINT_HD AovSample traceOne(const AovLaunch& launch, int x, int y) {
    return traceAovPixel<kMask>(launch.view, launch.params, x, y);
}

template <FeatureMask kMask, class Sample>
GLINT_HD void threadBody(const Launch<Sample>& launch, uint32_t index) {
    if (index >= launch.count) return;
    const PixelPlace at = pixelOfThread(launch.first + index, launch.params.width);
    if (at.x >= launch.params.width || at.y >= launch.params.height) return;
    launch.image[static_cast<size_t>(at.y) * launch.params.width + at.x] =
        traceOne<kMask>(launch, at.x, at.y);
}

template <FeatureMask kMask, class Sample>
__global__ void __launch_bounds__(kBlockThreads) kernel(const __grid_constant__ Launch<Sample> launch) {
    threadBody<kMask>(launch, blockIdx.x * kBlockThreads + threadIdx.x);
}

template <FeatureMask kMask, class Sample>
int launchOnGpu(const Launch<Sample>& launch, GpuStream stream) {
    const uint32_t blocks = (launch.count + kBlockThreads - 1) / kBlockThreads;
    kernel<kMask><<<blocks, kBlockThreads, 0, static_cast<cudaStream_t>(stream)>>>(launch);
    return cudaGetLastError();
}

template <FeatureMask kMask, class Sample>
void runOnHost(const Launch<Sample>& launch) {
    for (uint32_t index = 0; index < launch.count; ++index) threadBody<kMask>(launch, index);
}

template <FeatureMask kMask>
constexpr CudaVariant makeVariant(const char* name) {
    constexpr FeatureMask kCompiled = kMask | kCompiledForGpu;
    return {name,
            kMask,
            launchOnGpu<kCompiled, PixelSample>,
            launchOnGpu<kCompiled, AovSample>,
            runOnHost<kCompiled, PixelSample>,
            runOnHost<kCompiled, AovSample>};
}

}  // namespace glint::cuda_kernels
