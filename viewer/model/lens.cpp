#include "viewer/model/lens.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/math/vec.h"

namespace glint {
namespace {

constexpr auto kSensors = std::to_array<SensorSize>({{"Full frame, 36 × 24 mm", 24.0f},
                                                     {"APS-C, 23.6 × 15.7 mm", 15.7f},
                                                     {"Four Thirds, 17.3 × 13 mm", 13.0f},
                                                     {"Super 35, 24.9 × 18.7 mm", 18.7f},
                                                     {"Medium format, 43.8 × 32.9 mm", 32.9f},
                                                     {"Custom", 0.0f}});

/// Pixels of a metre across in the distance of a metre, times the aperture: the circle of a point at
/// half the focal distance, times that distance. With parallel rays: the circle of a point at twice the
/// focal distance.
float blurFactor(const Camera& camera, int imageHeight) {
    return camera.apertureDiameter * static_cast<float>(imageHeight) / heightOfView(camera, 1.0f);
}

}  // namespace

std::span<const SensorSize> sensorSizes() { return kSensors; }

float focalLengthMm(const Camera& camera, float sensorHeightMm) {
    return 0.5f * sensorHeightMm / std::tan(camera.verticalFovDeg * kPi / 360.0f);
}

float fovDegForFocalLength(float focalLength, float sensorHeightMm) {
    return std::atan(0.5f * sensorHeightMm / focalLength) * 360.0f / kPi;
}

float fStop(const Camera& camera, float sensorHeightMm) {
    const float diameterMm = 1000.0f * camera.apertureDiameter;
    return diameterMm > 0.0f ? focalLengthMm(camera, sensorHeightMm) / diameterMm : kInfinity;
}

float apertureForFStop(const Camera& camera, float stop, float sensorHeightMm) {
    if (!(stop > 0.0f) || !std::isfinite(stop)) { return 0.0f; }
    return focalLengthMm(camera, sensorHeightMm) / (1000.0f * stop);
}

float fStopInThirds(float stop, int thirds) {
    const float nearest = std::round(6.0f * std::log2(stop));
    return std::exp2((nearest + static_cast<float>(thirds)) / 6.0f);
}

float blurPixels(const Camera& camera, float depth, int imageHeight) {
    const float factor = blurFactor(camera, imageHeight);
    return camera.kind == ProjectionKind::Orthographic
               ? factor * (depth / camera.focalDistance - 1.0f)
               : factor * (1.0f / camera.focalDistance - 1.0f / depth);
}

SharpRange sharpRange(const Camera& camera, float pixels, int imageHeight) {
    const float factor = blurFactor(camera, imageHeight);
    if (factor <= 0.0f) { return {.nearLimit = 0.0f, .farLimit = kInfinity, .hyperfocal = 0.0f}; }
    const float slack = pixels / factor;
    if (camera.kind == ProjectionKind::Orthographic) {
        return {.nearLimit = camera.focalDistance * std::max(1.0f - slack, 0.0f),
                .farLimit = camera.focalDistance * (1.0f + slack),
                .hyperfocal = kInfinity};
    }
    const float inFocus = 1.0f / camera.focalDistance;
    return {.nearLimit = 1.0f / (inFocus + slack),
            .farLimit = inFocus > slack ? 1.0f / (inFocus - slack) : kInfinity,
            .hyperfocal = factor / pixels};
}

}  // namespace glint
