// Editable lights that have no shape, and the environment. Shapes emit through their material.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/base/kinds.h"
#include "engine/math/vec.h"
#include "engine/scene/image.h"
#include "engine/scene/material.h"

namespace glint {

struct Light {
    std::string name;
    LightKind kind = LightKind::Point;
    Vec3 position{0.0f};                ///< all but directional; metres
    Vec3 direction{0.0f, -1.0f, 0.0f};  ///< all but point: where the light travels; any length but zero
    /// point, spot, goniometric: intensity W/sr; directional: irradiance W/m^2 facing it; projector:
    /// likewise, on the plane at a distance of 1 m
    Vec3 color{1.0f};
    float strength = 1.0f;              ///< multiplies `color`
    float coneAngleDeg = 40.0f;         ///< spot: half angle where the light ends, (0, 90]
    float coneFalloffStartDeg = 30.0f;  ///< spot: half angle where it begins to fall off, [0, coneAngleDeg]
    Vec3 up{0.0f, 1.0f, 0.0f};          ///< projector, goniometric: upwards in the picture; not zero
    float fovDeg = 40.0f;               ///< projector: full angle across the picture's width, (0, 180)
    float aspect = 1.0f;                ///< projector: width over height
    /// Multiplies `color`. Projector: an image as seen from there. Goniometric: by the direction of the light
    /// in a square of equal areas (math/equal_area.h), `direction` in its middle, `up` at its top.
    ColorInput image{Vec3(1.0f)};
    bool onlyRayCast = false;  ///< shines in ray casting alone
};

/// Whether the kind of light has a picture and an `up`.
constexpr bool hasImage(LightKind kind) {
    return kind == LightKind::Projector || kind == LightKind::Goniometric;
}

/// Unit, to the right in a light's picture; some direction across where it shines along `up`.
Vec3 imageRight(const Light& light);

/// Whether the points are the corners of a rectangle one after the other: edges are parallel and at right
/// angles within a thousandth.
bool isRectangle(const std::vector<Vec3>& corners);

/// Light from infinitely far away, and the background.
struct Environment {
    Vec3 color{0.0f};  ///< radiance; multiplies the image where there is one
    float strength = 1.0f;
    int image = -1;            ///< lat-long image: index into SceneDescription::environmentImages, or -1
    float rotationDeg = 0.0f;  ///< about +y, counter-clockwise seen from above
    bool seenOnly = false;     ///< a background: rays from the camera see it, and it lights nothing
    /// Corners of the rectangle through which alone it is seen and shines, counter-clockwise as seen from
    /// where its light goes; metres. Empty: it comes from everywhere.
    std::vector<Vec3> portal = {};

    bool emissive() const { return strength > 0.0f && maxComponent(color) > 0.0f; }
};

}  // namespace glint
