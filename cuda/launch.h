// One launch: a run of threads, each of which does one pixel of a pass, and where its pixel lies. Plain data,
// host and device.
//
// Threads are numbered tile by tile, so that the 32 of a warp see neighbouring pixels, and a pass can be cut
// into launches between any two of them.
#pragma once

#include "engine/kernels/pass.h"
#include "engine/kernels/scene_view.h"

namespace glint {

constexpr int kTileWidth = 8;
constexpr int kTileHeight = 4;

/// Threads [first, first + count) of a pass. All pointers are the device's; `image` is the whole picture.
template <class Sample>
struct ImageLaunch {
    SceneView view;
    PassParams params;
    Sample* image = nullptr;
    uint32_t first = 0;
    uint32_t count = 0;
};
using PathLaunch = ImageLaunch<PixelSample>;
using AovLaunch = ImageLaunch<AovSample>;

struct PixelPlace {
    int x, y;
};

GLINT_HD constexpr int tilesAcross(int width) { return (width + kTileWidth - 1) / kTileWidth; }
GLINT_HD constexpr int tilesDown(int height) { return (height + kTileHeight - 1) / kTileHeight; }

/// Threads of a whole pass: every pixel, and those of the border tiles that lie outside.
GLINT_HD constexpr uint32_t threadsOfPass(int width, int height) {
    return static_cast<uint32_t>(tilesAcross(width)) * static_cast<uint32_t>(tilesDown(height)) *
           static_cast<uint32_t>(kTileWidth * kTileHeight);
}

/// The pixel of a thread of the pass; outside the picture for some threads of its right and lower tiles.
GLINT_HD constexpr PixelPlace pixelOfThread(uint32_t thread, int width) {
    const uint32_t lane = thread % (kTileWidth * kTileHeight);
    const uint32_t tile = thread / (kTileWidth * kTileHeight);
    const uint32_t across = static_cast<uint32_t>(tilesAcross(width));
    return {static_cast<int>(tile % across * kTileWidth + lane % kTileWidth),
            static_cast<int>(tile / across * kTileHeight + lane / kTileWidth)};
}

}  // namespace glint
