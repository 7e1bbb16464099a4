// What the centre of the lens sees: for focusing and overlays, without noise, and in no renderer's way.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "engine/builders/built_scene.h"

namespace glint {

struct FirstHit {
    float depth = 0.0f;     ///< metres along the view axis; 0: nothing is hit
    uint32_t object = 0;    ///< number in SceneDescription::objects, plus 1
    uint32_t material = 0;  ///< likewise
};

/// In the middle of pixel (x, y) of a picture of this size.
FirstHit firstHit(const BuiltScene& scene, int width, int height, int x, int y);

/// On the straight way between two points, both left out; the depth is metres from `from`.
FirstHit firstHitBetween(const BuiltScene& scene, const Vec3& from, const Vec3& to);

/// The depths of all pixels, row 0 at the top. Looks at `stop` after each row; empty when it was raised.
std::vector<float> firstDepths(const BuiltScene& scene, int width, int height, const std::atomic<bool>& stop);

}  // namespace glint
