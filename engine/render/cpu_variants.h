// The kernels compiled for the CPU: one variant for each named feature mask, each in its own
// translation unit.
//
// The CPU backend asks for the smallest variant that does what a scene needs and calls it tile by tile.
#pragma once

#include <span>

#include "engine/kernels/features.h"
#include "engine/kernels/pass.h"
#include "engine/kernels/scene_view.h"
#include "engine/render/path_replay.h"
#include "engine/render/variant_choice.h"

namespace glint {

/// Pixels [x0, x1) x [y0, y1) of the picture.
struct PixelRect {
    int x0, y0, x1, y1;
};

/// Renders one tile of one pass. `image` is the whole picture, row-major, params.width entries a row, row 0
/// at the top. Reentrant: tiles may run on any number of threads.
using RenderTile = void (*)(const SceneView& view, const PassParams& params, const PixelRect& tile,
                            PixelSample* image);
using RenderAovTile = void (*)(const SceneView& view, const PassParams& params, const PixelRect& tile,
                               AovSample* image);

/// Repeats one pixel's path with every event: the same bits as the same variant's tile has.
using ReplayPixel = PathReplay (*)(const SceneView& view, const PassParams& params, int x, int y);

struct KernelVariant {
    const char* name;  ///< for `glint info`
    FeatureMask mask;
    RenderTile renderTile;
    RenderAovTile renderAovTile;
    ReplayPixel replayPixel;
};

/// All variants from the smallest to the full one.
std::span<const KernelVariant> kernelVariants();

}  // namespace glint
