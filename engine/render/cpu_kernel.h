// The tile loops and replays that the CPU variants compile, one for each mask of kernels/named_masks.h they
// are made for.
//
// cpu_variants.cpp takes their addresses; each cpu_kernel_<name>.cpp holds the code of one mask, so that they
// compile side by side. Only cpu_kernel_*.cpp may include cpu_kernel_tile.h.
#pragma once

#include "engine/kernels/named_masks.h"
#include "engine/render/cpu_variants.h"

namespace glint {

template <FeatureMask kMask>
void renderTile(const SceneView& view, const PassParams& params, const PixelRect& tile, PixelSample* image);

template <FeatureMask kMask>
void renderAovTile(const SceneView& view, const PassParams& params, const PixelRect& tile, AovSample* image);

template <FeatureMask kMask>
PathReplay replayPixel(const SceneView& view, const PassParams& params, int x, int y);

}  // namespace glint
