// A procedural sky for image environments, so that scenes need no HDR files.
//
// A smooth gradient with a soft-edged sun: made to look good, not measured. For physical skies load an
// HDR image.
#pragma once

#include <memory>

#include "engine/math/vec.h"

namespace glint {

struct ImageF;

/// Radiances are linear Rec.709. Azimuth 0 is +x and grows towards -z (counter-clockwise seen from above).
struct SkySource {
    Vec3 zenith{0.18f, 0.36f, 0.80f};   ///< radiance straight up
    Vec3 horizon{0.80f, 0.88f, 1.00f};  ///< radiance at the horizon, seen from above it
    Vec3 ground{0.25f, 0.23f, 0.21f};   ///< radiance below the horizon
    Vec3 sun{400.0f, 340.0f, 260.0f};   ///< radiance of the sun's disc, added to the sky; black: no sun
    float sunElevationDeg = 35.0f;      ///< above the horizon, [-90, 90]
    float sunAzimuthDeg = 60.0f;
    float sunRadiusDeg = 2.5f;  ///< half the angle it subtends, [0.1, 90]; the real one is 0.27
    int width = 1024;           ///< pixels around; the height is half of it, [16, 8192], even

    bool operator==(const SkySource&) const = default;
};

/// The lat-long image of the sky: row 0 at the zenith. `sky` must be in range. Deterministic.
std::shared_ptr<const ImageF> generateSky(const SkySource& sky);

}  // namespace glint
