// The path kernels for the GPU: what a thread does.
//
// Included by one small .cu file for each variant, and by nothing else. The bodies only find their pixel: all
// that is computed there is in engine/kernels.
#pragma once

#include "cuda/cuda_variant.h"
#include "cuda/kernel_launch.cuh"
#include "engine/kernels/aov_kernel.h"
#include "engine/kernels/named_masks.h"
#include "engine/kernels/path_kernel.h"

namespace glint::cuda_kernels {

template <FeatureMask kMask>
GLINT_HD PixelSample traceOne(const PathLaunch& launch, int x, int y) {
    return tracePixel<kMask>(launch.view, launch.params, x, y);
}
template <FeatureMask kMask>
GLINT_HD AovSample traceOne(const AovLaunch& launch, int x, int y) {
    return traceAovPixel<kMask>(launch.view, launch.params, x, y);
}

template <FeatureMask kMask>
struct TracePixels {
    template <class Sample>
    static GLINT_HD void run(const ImageLaunch<Sample>& launch, uint32_t thread) {
        const PixelPlace at = pixelOfThread(thread, launch.params.width);
        if (at.x >= launch.params.width || at.y >= launch.params.height) { return; }
        launch.image[static_cast<size_t>(at.y) * launch.params.width + at.x] =
            traceOne<kMask>(launch, at.x, at.y);
    }
};

template <FeatureMask kMask>
constexpr CudaVariant makeVariant(const char* name) {
    using Body = TracePixels<kMask | kCompiledForGpu>;
    return {name, kMask, makeKernel<Body, PathLaunch>("path", name),
            makeKernel<Body, AovLaunch>("AOV", name)};
}

}  // namespace glint::cuda_kernels
