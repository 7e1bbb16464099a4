// The SPPM kernels that depend on the feature mask: what a thread does.
//
// Included by one small .cu file for each variant, and by nothing else. All that is computed there is
// in engine/kernels.
#pragma once

#include "cuda/kernel_launch.cuh"
#include "cuda/shared_counter.cuh"
#include "cuda/sppm_variant.h"
#include "engine/kernels/named_masks.h"
#include "engine/kernels/sppm_camera_kernel.h"
#include "engine/kernels/sppm_pass_steps.h"
#include "engine/kernels/sppm_photon_kernel.h"

namespace glint::cuda_kernels {

template <FeatureMask kMask>
struct TraceCamera {
    static GLINT_HD void run(const CameraLaunch& launch, uint32_t thread) {
        const PassParams& pass = launch.params.pass;
        const PixelPlace at = pixelOfThread(thread, pass.width);
        if (at.x >= pass.width || at.y >= pass.height) { return; }
        const size_t pixel = static_cast<size_t>(at.y) * pass.width + at.x;
        launch.direct[pixel] = traceVisiblePoint<kMask>(launch.view, launch.params, at.x, at.y,
                                                        &launch.pixels[pixel].visiblePoint);
    }
};

template <FeatureMask kMask>
struct TracePhotons {
    static GLINT_HD void run(const PhotonLaunch& launch, uint32_t photon) {
        const PhotonSlots& slots = launch.slots;
        const uint64_t number =
            uint64_t{launch.params.pass.pass} * launch.params.photonsPerPass + uint64_t{photon};
        uint32_t stored = 0;
        tracePhoton<kMask>(launch.view, launch.power, launch.params, number, [&](const Photon& found) {
            uint32_t cell[3];
            if (!launch.space.locate(found.p, cell)) { return; }
            const uint64_t slot = takeNumber(slots.claimed);
            if (slot < slots.capacity) {
                slots.photons[slot] = found;
                slots.places[slot] = uint64_t{photon} << 32 | stored;
            }
            ++stored;
        });
        slots.stored[photon] = stored;
    }
};

template <FeatureMask kMask>
struct GatherPhotons {
    static GLINT_HD void run(const GatherLaunch& launch, uint32_t thread) {
        const PassParams& pass = launch.params.pass;
        const PixelPlace at = pixelOfThread(thread, pass.width);
        if (at.x >= pass.width || at.y >= pass.height) { return; }
        const size_t pixel = static_cast<size_t>(at.y) * pass.width + at.x;
        gatherPixel<kMask>(launch.view, launch.photons, launch.params, at.x, at.y, launch.statistics[pixel],
                           &launch.pixels[pixel]);
    }
};

template <FeatureMask kMask>
constexpr CudaSppmVariant makeSppmVariant(const char* name) {
    constexpr FeatureMask kCompiled = kMask | kCompiledForGpu;
    return {name, kMask, makeKernel<TraceCamera<kCompiled>, CameraLaunch>("camera", name),
            makeKernel<TracePhotons<kCompiled>, PhotonLaunch>("photons", name),
            makeKernel<GatherPhotons<kCompiled>, GatherLaunch>("gather", name)};
}

}  // namespace glint::cuda_kernels
