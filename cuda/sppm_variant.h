// The SPPM kernels compiled for the GPU: those that trace and shade for each feature mask, the others once.
//
// The masks are among the CPU's (render/sppm_variants.cpp), whose results they give bit for bit on the host.
#pragma once

#include <span>

#include "cuda/kernel.h"
#include "cuda/sppm_launch.h"
#include "engine/kernels/features.h"

namespace glint {

struct CudaSppmVariant {
    const char* name;
    FeatureMask mask;
    Kernel<CameraLaunch> camera;
    Kernel<PhotonLaunch> photons;
    Kernel<GatherLaunch> gather;
};

/// The kernels that only move and count, in the order in which they run.
struct PhotonSteps {
    Kernel<SpaceLaunch> findBounds;
    Kernel<SpaceLaunch> findLevels;
    Kernel<KeyLaunch> makeKeys;
    Kernel<MoveLaunch> takeParts;
    Kernel<MoveLaunch> placeParts;
    Kernel<TableLaunch> countCells;
    Kernel<TableLaunch> enterCells;
    Kernel<TableLaunch> closeCells;
    Kernel<UpdateLaunch> update;
};
extern const PhotonSteps kPhotonSteps;

/// All variants from the smallest to the full one.
std::span<const CudaSppmVariant> cudaSppmVariants();

}  // namespace glint
