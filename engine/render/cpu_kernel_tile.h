// The bodies of cpu_kernel.h's templates. For cpu_kernel_*.cpp only: including it compiles the whole
// path tracer.
#pragma once

#include "engine/kernels/aov_kernel.h"
#include "engine/kernels/path_kernel.h"
#include "engine/render/cpu_camera_rays.h"
#include "engine/render/cpu_kernel.h"
#include "engine/render/one_piece.h"

namespace glint {

template <FeatureMask kMask>
void renderPixels(const SceneView& view, const PassParams& params, const PixelRect& tile,
                  PixelSample* image) {
    NoPathLog log;
    forEachCameraRay(view.camera, params, tile, [&](int x, int y, const Sampler& sampler, const Ray& ray) {
        image[static_cast<size_t>(y) * static_cast<size_t>(params.width) + static_cast<size_t>(x)] =
            tracePathLogged<kMask>(view, params, sampler, ray, &log);
    });
}

template <FeatureMask kMask>
void renderTile(const SceneView& view, const PassParams& params, const PixelRect& tile, PixelSample* image) {
    onePieceOf<kMask, &renderPixels<kMask>>()(view, params, tile, image);
}

template <FeatureMask kMask>
void renderAovTile(const SceneView& view, const PassParams& params, const PixelRect& tile, AovSample* image) {
    for (int y = tile.y0; y < tile.y1; ++y) {
        AovSample* row = image + static_cast<size_t>(y) * static_cast<size_t>(params.width);
        for (int x = tile.x0; x < tile.x1; ++x) {
            row[x] = traceAovPixel<kMask>(view, params, x, y);
        }
    }
}

struct RecordingLog {
    static constexpr bool kEnabled = true;
    std::vector<PathEvent> events;

    void add(const PathEvent& event) { events.push_back(event); }
};

template <FeatureMask kMask>
PathReplay replayPixel(const SceneView& view, const PassParams& params, int x, int y) {
    RecordingLog log;
    const PixelSample sample = tracePixelLogged<kMask>(view, params, x, y, &log);
    return {sample, std::move(log.events)};
}

}  // namespace glint

/// Compiles all of it for one mask.
#define GLINT_COMPILE_KERNELS(mask)                                                                 \
    template void glint::renderTile<mask>(const SceneView&, const PassParams&, const PixelRect&,    \
                                          PixelSample*);                                            \
    template void glint::renderAovTile<mask>(const SceneView&, const PassParams&, const PixelRect&, \
                                             AovSample*);                                           \
    template glint::PathReplay glint::replayPixel<mask>(const SceneView&, const PassParams&, int, int)
