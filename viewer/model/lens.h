// The thin lens in the words of photographers: sensors, focal lengths, f-stops, what is sharp.
//
// The scene knows an angle of view and an aperture in metres; a sensor's height makes a focal length and an
// f-stop of them. The picture is that of a lens that keeps its angle when it focuses.
#pragma once

#include <span>

#include "engine/scene/camera.h"

namespace glint {

struct SensorSize {
    const char* name;
    float heightMm;  ///< 0: the user's own
};
/// The first is the usual one; the last one is the user's own.
std::span<const SensorSize> sensorSizes();

/// Millimetres; a lens that has the camera's vertical angle of view on this sensor.
float focalLengthMm(const Camera& camera, float sensorHeightMm);
/// Full vertical angle in degrees.
float fovDegForFocalLength(float focalLengthMm, float sensorHeightMm);

/// Focal length over aperture diameter. Infinite for a pinhole.
float fStop(const Camera& camera, float sensorHeightMm);
/// Aperture diameter in metres for an f-stop; 0 for an infinite one.
float apertureForFStop(const Camera& camera, float fStop, float sensorHeightMm);
/// The nearest of the f-stops a third apart (2^(k/6)), `thirds` further.
float fStopInThirds(float fStop, int thirds);

/// Diameter of the circle of confusion in pixels of a picture of this height, of a point `depth` metres along
/// the view axis. Negative in front of what is in focus.
float blurPixels(const Camera& camera, float depth, int imageHeight);

/// Metres along the view axis.
struct SharpRange {
    float nearLimit = 0.0f;
    float farLimit = 0.0f;    ///< infinite from the hyperfocal distance on
    float hyperfocal = 0.0f;  ///< the nearest focus that is sharp to infinity; 0 for a pinhole, infinite for
                              ///< parallel rays
};
/// Where circles of confusion have at most `pixels`. A pinhole is sharp everywhere.
SharpRange sharpRange(const Camera& camera, float pixels, int imageHeight);

}  // namespace glint
