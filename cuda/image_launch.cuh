// Kernels that do one pixel a thread. Included by .cu files only.
#pragma once

#include "cuda/kernel_launch.cuh"
#include "cuda/launch.h"

namespace glint::cuda_kernels {

/// Trace is a struct with a static GLINT_HD pixel(launch, x, y), which answers the sample.
template <class Trace>
struct EachPixel {
    template <class Launch>
    static GLINT_HD void run(const Launch& launch, uint32_t thread) {
        const PixelPlace at = pixelOfThread(thread, launch.params.width);
        if (at.x >= launch.params.width || at.y >= launch.params.height) { return; }
        launch.image[static_cast<size_t>(at.y) * launch.params.width + at.x] =
            Trace::pixel(launch, at.x, at.y);
    }
};

}  // namespace glint::cuda_kernels
