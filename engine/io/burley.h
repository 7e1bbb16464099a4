// The parameters of Burley's principled model (Burley 2012, "Physically-Based Shading at Disney") as a
// principled material of Glint has them.
#pragma once

#include "engine/math/color.h"
#include "engine/math/vec.h"

namespace glint {

/// Burley's whole coat has a quarter of a boundary's strength.
constexpr float kBurleyCoat = 0.25f;

/// The GGX alpha that stands for that of his coat's narrower-waisted distribution.
inline float burleyCoatAlpha(float gloss) { return 0.1f + clampf(gloss, 0.0f, 1.0f) * (0.001f - 0.1f); }
/// Its inverse.
inline float burleyCoatGloss(float alpha) { return clampf((0.1f - alpha) / (0.1f - 0.001f), 0.0f, 1.0f); }

/// Sheen of this alpha and a tenth of the strength reflects as much as his, about alike over the angles.
constexpr float kBurleySheenAlpha = 0.1f;
constexpr float kBurleySheen = 0.1f;

/// White, or so much of the colour's hue.
inline Vec3 burleyTint(const Vec3& color, float tint) {
    const float brightness = luminance(color);
    const Vec3 hue = brightness > 0.0f ? color / brightness : Vec3(1.0f);
    return glm::clamp(glm::mix(Vec3(1.0f), hue, clampf(tint, 0.0f, 1.0f)), Vec3(0.0f), Vec3(1.0f));
}

}  // namespace glint
