// The procedural sky: a gradient by elevation, a soft horizon, a sun with a glow. Our own blend, tuned
// by eye.
#include "engine/scene/generated_sky.h"

#include "engine/scene/image.h"

namespace glint {
namespace {

float smoothStep(float from, float to, float x) {
    const float t = clampf((x - from) / (to - from), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

Vec3 blend(const Vec3& a, const Vec3& b, float t) { return a + t * (b - a); }

struct Sun {
    Vec3 direction;
    float radiusRad;
    float edgeRad;  ///< over which the disc's edge fades, so that coarse images do not alias
};

Sun makeSun(const SkySource& sky) {
    const float elevation = sky.sunElevationDeg * (kPi / 180.0f);
    const float azimuth = sky.sunAzimuthDeg * (kPi / 180.0f);
    const float radiusRad = sky.sunRadiusDeg * (kPi / 180.0f);
    const float pixelRad = kTwoPi / static_cast<float>(sky.width);
    return {{std::cos(elevation) * std::cos(azimuth), std::sin(elevation),
             -std::cos(elevation) * std::sin(azimuth)},
            radiusRad,
            std::fmax(pixelRad, 0.1f * radiusRad)};
}

/// Radiance of the sky without the sun's disc: the colours meet within half a degree of the horizon.
Vec3 gradient(const SkySource& sky, float y) {
    const float height = std::pow(std::fmax(y, 0.0f), 0.55f);
    return blend(sky.ground, blend(sky.horizon, sky.zenith, height), smoothStep(-0.01f, 0.005f, y));
}

Vec3 radianceOf(const SkySource& sky, const Sun& sun, const Vec3& w) {
    const float cosAngle = clampf(glm::dot(w, sun.direction), -1.0f, 1.0f);
    // atan2 of the chord stays accurate near the sun, where acos does not.
    const float angleRad = 2.0f * std::atan2(glm::length(w - sun.direction), glm::length(w + sun.direction));
    const float disc = 1.0f - smoothStep(sun.radiusRad - sun.edgeRad, sun.radiusRad + sun.edgeRad, angleRad);
    const float glow = std::pow(std::fmax(cosAngle, 0.0f), 64.0f) * smoothStep(-0.02f, 0.02f, w.y);
    constexpr float kGlowShare = 0.0015f;
    return gradient(sky, w.y) + sky.sun * (disc + kGlowShare * glow);
}

}  // namespace

std::shared_ptr<const ImageF> generateSky(const SkySource& sky) {
    auto image = std::make_shared<ImageF>();
    image->width = sky.width;
    image->height = sky.width / 2;
    image->rgb.reserve(size_t{3} * static_cast<size_t>(image->width) * static_cast<size_t>(image->height));
    const Sun sun = makeSun(sky);
    for (int row = 0; row < image->height; ++row) {
        const float theta = kPi * (static_cast<float>(row) + 0.5f) / static_cast<float>(image->height);
        for (int column = 0; column < image->width; ++column) {
            // The environment's mapping: the middle column looks along -z, columns to the right towards +x.
            const float phi =
                kTwoPi * ((static_cast<float>(column) + 0.5f) / static_cast<float>(image->width) - 0.5f);
            const Vec3 w(std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi));
            const Vec3 rgb = radianceOf(sky, sun, w);
            image->rgb.insert(image->rgb.end(), {rgb.x, rgb.y, rgb.z});
        }
    }
    return image;
}

}  // namespace glint
