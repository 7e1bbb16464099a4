// The light that a picture shows as white: a display setting, as exposure is.
#pragma once

#include "engine/math/vec.h"

namespace glint {

/// 6504 K without tint is what white of Rec.709 (D65) is: then nothing changes, not a bit.
struct WhiteBalance {
    /// kLeastKelvin to kMostKelvin: of the light that turns white; lower makes bluer
    float kelvin = 6504.0f;
    float tint = 0.0f;  ///< -kMostTint to kMostTint: above 0 takes green out

    bool operator==(const WhiteBalance&) const = default;
    bool isNeutral() const { return *this == WhiteBalance{}; }
};

constexpr float kLeastKelvin = 2000.0f;
constexpr float kMostKelvin = 15000.0f;
constexpr float kMostTint = 100.0f;

/// Linear Rec.709 to the same, such that light of that temperature becomes white of the same luminance: cone
/// responses of Bradford's matrix are scaled (von Kries 1902; Lam 1985). The light lies beside the Planckian
/// locus (Krystek 1985, "An algorithm to calculate correlated colour temperature", in CIE 1960 u, v) by as
/// much as D65 does, plus 0.0002 for each step of tint.
Mat3 whiteBalanceMatrix(const WhiteBalance& white);

}  // namespace glint
