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

/// The root of across over along of his two alphas, whose product is the fourth power of the roughness.
inline float burleyAspect(float anisotropic) {
    return std::sqrt(1.0f - 0.9f * clampf(anisotropic, 0.0f, 1.0f));
}
/// Its inverse, for alphas of which the first is the larger one; most: 1.
inline float burleyAnisotropic(float along, float across) {
    return clampf((1.0f - across / maxf(along, 1e-9f)) / 0.9f, 0.0f, 1.0f);
}

/// White, or so much of the colour's hue.
inline Vec3 burleyTint(const Vec3& color, float tint) {
    const float brightness = luminance(color);
    const Vec3 hue = brightness > 0.0f ? color / brightness : Vec3(1.0f);
    return glm::clamp(glm::mix(Vec3(1.0f), hue, clampf(tint, 0.0f, 1.0f)), Vec3(0.0f), Vec3(1.0f));
}

}  // namespace glint
