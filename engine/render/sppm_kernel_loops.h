// The bodies of sppm_kernel.h's loops. For sppm_kernel_*.cpp only: including it compiles all SPPM kernels.
#pragma once

#include "engine/kernels/sppm_camera_kernel.h"
#include "engine/kernels/sppm_pass_steps.h"
#include "engine/kernels/sppm_photon_kernel.h"
#include "engine/render/cpu_camera_rays.h"
#include "engine/render/one_piece.h"
#include "engine/render/sppm_kernel.h"

namespace glint {
namespace detail {

template <FeatureMask kMask>
void traceVisiblePoints(const SceneView& view, const SppmParams& params, const PixelRect& tile,
                        PixelSample* image, PassPixel* pixels) {
    const auto visiblePointOf = [&](int x, int y, const Sampler& sampler, const Ray& ray) {
        const size_t pixel =
            static_cast<size_t>(y) * static_cast<size_t>(params.pass.width) + static_cast<size_t>(x);
        image[pixel] = traceVisiblePoint<kMask>(view, params, sampler, ray, &pixels[pixel].visiblePoint);
    };
    forEachCameraRay(view.camera, params.pass, tile, visiblePointOf);
}

template <FeatureMask kMask>
PhotonTotals tracePhotons(const SceneView& view, const PowerDistributionView& power, const SppmParams& params,
                          const PhotonRange& range, const GridSpace& space, PhotonStore::Writer* writer) {
    PhotonTotals totals;
    for (uint64_t number = range.first; number < range.end; ++number) {
        const PhotonTally tally = tracePhoton<kMask>(view, power, params, number, [&](const Photon& photon) {
            uint32_t cell[3];
            if (space.locate(photon.p, cell)) { writer->add(photon); }
        });
        totals.emitted += static_cast<double>(tally.emitted);
        totals.escaped += static_cast<double>(tally.escaped);
        totals.rays += tally.rays;
        totals.faulty += tally.faulty ? 1 : 0;
    }
    return totals;
}

template <FeatureMask kMask, class PhotonMap>
void gatherPixels(const SceneView& view, const PhotonMap& photons, const SppmParams& params,
                  const SppmPixel* statistics, size_t begin, size_t end, PassPixel* pixels) {
    for (size_t i = begin; i < end; ++i) {
        const auto width = static_cast<size_t>(params.pass.width);
        gatherPixel<kMask>(view, photons, params, static_cast<int>(i % width), static_cast<int>(i / width),
                           statistics[i], &pixels[i]);
    }
}

}  // namespace detail

template <FeatureMask kMask>
SppmVariant sppmVariant(const char* name) {
    return {name,
            kMask,
            onePieceOf<kMask, &detail::traceVisiblePoints<kMask>>(),
            onePieceOf<kMask, &detail::tracePhotons<kMask>>(),
            onePieceOf<kMask, &detail::gatherPixels<kMask, PhotonGridView>>(),
            &detail::gatherPixels<kMask, PhotonTreeView>};
}

}  // namespace glint

/// Compiles all loops for one mask.
#define GLINT_COMPILE_SPPM(mask) template glint::SppmVariant glint::sppmVariant<mask>(const char* name)
