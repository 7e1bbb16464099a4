// The path kernels for the GPU: what a thread does.
//
// Included by one small .cu file for each variant, and by nothing else. All that is computed there is
// in engine/kernels.
#pragma once

#include "cuda/cuda_variant.h"
#include "cuda/image_launch.cuh"
#include "engine/kernels/aov_kernel.h"
#include "engine/kernels/named_masks.h"
#include "engine/kernels/path_kernel.h"

namespace glint::cuda_kernels {

template <FeatureMask kMask>
struct TracePath {
    static GLINT_HD PixelSample pixel(const PathLaunch& launch, int x, int y) {
        return tracePixel<kMask>(launch.view, launch.params, x, y);
    }
};

template <FeatureMask kMask>
struct TraceAov {
    static GLINT_HD AovSample pixel(const AovLaunch& launch, int x, int y) {
        return traceAovPixel<kMask>(launch.view, launch.params, x, y);
    }
};

template <FeatureMask kMask>
constexpr CudaVariant makeVariant(const char* name) {
    constexpr FeatureMask kGpuMask = kMask | kCompiledForGpu;
    return {name, kMask, makeKernel<EachPixel<TracePath<kGpuMask>>, PathLaunch>("path", name),
            makeKernel<EachPixel<TraceAov<kGpuMask>>, AovLaunch>("AOV", name)};
}

}  // namespace glint::cuda_kernels
