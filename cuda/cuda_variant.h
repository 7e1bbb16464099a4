// The kernels compiled for the GPU: one variant for each feature mask, each in its own translation unit.
//
// The CUDA back end asks for the smallest variant that does what a scene needs. No CUDA header is named here,
// so that plain C++ sees it.
#pragma once

#include <span>

#include "cuda/kernel.h"
#include "cuda/launch.h"
#include "engine/kernels/features.h"

namespace glint {

struct CudaVariant {
    const char* name;
    FeatureMask mask;
    Kernel<PathLaunch> path;
    Kernel<AovLaunch> aov;
};

/// All variants from the smallest to the full one.
std::span<const CudaVariant> cudaVariants();

}  // namespace glint
