// What a launch of the noise-free previews is given beside the scene, and their kernels. They have one
// variant, with every feature. No CUDA header is named here.
#pragma once

#include "cuda/kernel.h"
#include "cuda/launch.h"
#include "engine/kernels/raycast_kernel.h"

namespace glint {

/// settings.materials is the device's.
struct RayCastLaunch : PathLaunch {
    RayCastView settings;
};
struct OcclusionLaunch : PathLaunch {
    float radiusWorld = 0.0f;
};

extern const Kernel<RayCastLaunch> kCudaRayCast;
extern const Kernel<OcclusionLaunch> kCudaAmbientOcclusion;

}  // namespace glint
