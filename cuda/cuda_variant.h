// The kernels compiled for the GPU: one variant for each feature mask, each in its own translation unit.
//
// The CUDA back end asks for the smallest variant that does what a scene needs. No CUDA header is named here,
// so that plain C++ sees it.
#pragma once

#include <span>

#include "cuda/launch.h"
#include "engine/kernels/features.h"

namespace glint {

/// The runtime's cudaStream_t.
using GpuStream = void*;

/// Launches answer the runtime's cudaError_t, 0 when started. The host functions run the very bodies of the
/// kernels, compiled in the same translation unit, in a loop over a launch whose pointers are the host's.
struct CudaVariant {
    const char* name;
    FeatureMask mask;
    int (*launchPath)(const PathLaunch& launch, GpuStream stream);
    int (*launchAov)(const AovLaunch& launch, GpuStream stream);
    void (*runPathOnHost)(const PathLaunch& launch);
    void (*runAovOnHost)(const AovLaunch& launch);
};

/// All variants from the smallest to the full one.
std::span<const CudaVariant> cudaVariants();

/// The first variant whose mask holds all of `needed`.
const CudaVariant& chooseCudaVariant(FeatureMask needed);

}  // namespace glint
