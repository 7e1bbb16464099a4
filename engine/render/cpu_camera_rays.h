// The camera rays of a whole tile at once; of a pinhole with the Sobol sampler in vector code.
//
// Bit for bit what makeSampler() and pixelRay() answer pixel by pixel.
#pragma once

#include <algorithm>

#include "engine/kernels/camera_path.h"
#include "engine/render/cpu_variants.h"

namespace glint {

constexpr int kCameraTileSize = 8;
constexpr int kCameraTilePixels = kCameraTileSize * kCameraTileSize;

/// One array for each number, an entry for each pixel, row by row.
struct alignas(64) CameraTile {
    uint64_t pixelKey[kCameraTilePixels];  ///< Sampler::pixelKey
    float originX[kCameraTilePixels];      ///< world space
    float originY[kCameraTilePixels];
    float originZ[kCameraTilePixels];
    float directionX[kCameraTilePixels];
    float directionY[kCameraTilePixels];
    float directionZ[kCameraTilePixels];

    Ray ray(int pixel) const {
        return {{originX[pixel], originY[pixel], originZ[pixel]},
                {directionX[pixel], directionY[pixel], directionZ[pixel]}};
    }
};

/// Fills the tile for pixels [x0, x0 + kCameraTileSize) x [y0, y0 + kCameraTileSize), also beyond the
/// picture's edge.
void fillCameraTile(const CameraData& camera, const PassParams& params, int x0, int y0, CameraTile* tile);

/// Calls body(x, y, sampler, cameraRay) for every pixel of `rect`.
template <class Body>
void forEachCameraRay(const CameraData& camera, const PassParams& params, const PixelRect& rect,
                      const Body& body) {
    CameraTile tile;
    Sampler sampler = makeSampler(params, 0, 0);
    for (int y0 = rect.y0; y0 < rect.y1; y0 += kCameraTileSize) {
        for (int x0 = rect.x0; x0 < rect.x1; x0 += kCameraTileSize) {
            fillCameraTile(camera, params, x0, y0, &tile);
            for (int i = 0; i < kCameraTilePixels; ++i) {
                const int x = x0 + i % kCameraTileSize;
                const int y = y0 + i / kCameraTileSize;
                if (x >= rect.x1 || y >= rect.y1) { continue; }
                sampler.pixelKey = tile.pixelKey[i];
                body(x, y, sampler, tile.ray(i));
            }
        }
    }
}

}  // namespace glint
