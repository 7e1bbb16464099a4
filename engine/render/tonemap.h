// From linear radiance to 8-bit display values: exposure and tone curves, and false colours for the
// other pictures.
//
// `glint render` writes PNGs with this; shaders/tonemap.frag mirrors toneMapped() line by line and agrees to
// 1/255. All formulas are plain float arithmetic, per channel except where said. Nothing here reaches the
// renderer or a film.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/math/color.h"
#include "engine/render/ocio_view.h"
#include "engine/render/white_balance.h"
#include "engine/scene/image.h"

namespace glint {

enum class ToneMap : uint8_t {
    Clamp,     ///< linear values cut to [0, 1] and stored without a gamma, as the seed's published pictures
    Srgb,      ///< cut to [0, 1], then the sRGB curve
    Filmic,    ///< filmicCurve(), then the sRGB curve
    Reinhard,  ///< reinhard(), then the sRGB curve
    Soft,      ///< softHighlights(), then the sRGB curve
};

constexpr int kToneMapCount = 5;

/// "clamp", "srgb", "filmic", "reinhard", "soft".
std::string_view toneMapName(ToneMap map);
std::optional<ToneMap> toneMapFromName(std::string_view name);

/// Rational fit of the ACES reference curve, x >= 0 (Narkowicz 2015, "ACES Filmic Tone Mapping Curve"), with
/// the input scaled by 0.6 as there, so that middle grey keeps its brightness. The result is in [0, 1].
inline float filmicCurve(float x) {
    const float v = 0.6f * x;
    return clampf((v * (2.51f * v + 0.03f)) / (v * (2.43f * v + 0.59f) + 0.14f), 0.0f, 1.0f);
}

/// Luminance that extended Reinhard maps to white.
constexpr float kReinhardWhite = 4.0f;

/// Extended Reinhard on luminance, keeping the colour's ratios (Reinhard et al. 2002, equation 4):
/// L' = L (1 + L / white^2) / (1 + L). Black stays black. Channels may exceed 1 and are cut afterwards.
inline Vec3 reinhard(const Vec3& rgb) {
    const float l = luminance(rgb);
    return rgb * ((1.0f + l / (kReinhardWhite * kReinhardWhite)) / (1.0f + l));
}

/// Of softHighlights(): the curve's steepness, and how much of the luminance is mixed in before and taken out
/// after it.
constexpr float kSoftContrast = 1.2f;
constexpr float kSoftMixedIn = 0.2f;
constexpr float kSoftTakenOut = 0.1f;
/// 0.18^kSoftContrast * 0.82 / 0.18: middle grey keeps its brightness.
constexpr float kSoftShoulder = 0.58193f;

/// x^c / (x^c + shoulder), for x >= 0 in [0, 1).
inline float softCurve(float x) {
    const float raised = std::pow(std::max(x, 0.0f), kSoftContrast);
    return raised / (raised + kSoftShoulder);
}

/// For colours that outshine the screen: they fade to white by their own hue, where a curve for each channel
/// alone turns orange to yellow and blue to cyan. The colour is mixed with its luminance (after Sobotka's
/// AgX); the curve moves its largest and smallest channel, and the third keeps its share between them; half
/// of the mixture is taken back. Values >= 0; results may lie beyond [0, 1] a little and are cut afterwards.
inline Vec3 softHighlights(const Vec3& rgb) {
    const Vec3 mixed = rgb + kSoftMixedIn * (Vec3(luminance(rgb)) - rgb);
    const float high = std::max({mixed.x, mixed.y, mixed.z});
    const float low = std::min({mixed.x, mixed.y, mixed.z});
    const float lowest = softCurve(low);
    const float slope = high > low ? (softCurve(high) - lowest) / (high - low) : 0.0f;
    const Vec3 curved = Vec3(lowest) + (mixed - Vec3(low)) * slope;
    return (curved - Vec3(kSoftTakenOut * luminance(curved))) / (1.0f - kSoftTakenOut);
}

/// Largest value that enters a curve: keeps every step finite in float for infinite input.
constexpr float kMaxToneInput = 1e6f;

/// Multiplied by 2^exposureStops and cut to [0, kMaxToneInput]; NaN becomes 0.
Vec3 exposed(const Vec3& radiance, float exposureStops);
/// Radiance to display values in [0, 1]: exposed(), then the operator.
Vec3 toneMapped(Vec3 radiance, float exposureStops, ToneMap map);

/// All that stands between radiance and the bytes of a screen.
struct DisplayLook {
    float exposureStops = 0.0f;
    ToneMap toneMap = ToneMap::Srgb;
    WhiteBalance white{};
    bool dithers = false;                    ///< of pictures alone: bytes are rounded by ditherOffset()
    std::shared_ptr<const OcioView> view{};  ///< in place of the tone map; null: none

    bool operator==(const DisplayLook&) const = default;
};

/// toneMapped() of many pixels, or what the look's view makes of them, after its white balance.
class ToneMapper {
  public:
    explicit ToneMapper(const DisplayLook& look)
        : look_(look), isNeutral_(look.white.isNeutral()), balance_(whiteBalanceMatrix(look.white)) {}
    Vec3 operator()(const Vec3& radiance) const {
        const Vec3 balanced = isNeutral_ ? radiance : balance_ * radiance;
        return look_.view ? (*look_.view)(exposed(balanced, look_.exposureStops))
                          : toneMapped(balanced, look_.exposureStops, look_.toneMap);
    }

  private:
    DisplayLook look_;
    bool isNeutral_;
    Mat3 balance_;
};

/// What is added to 255 times the display value of a pixel's channel before it is rounded, in [-0.5, 0.5):
/// interleaved gradient noise (Jimenez 2014, "Next Generation Post Processing in Call of Duty: Advanced
/// Warfare"), so that gradients show no steps. 0 and 1 stay what they are.
inline float ditherOffset(int x, int y, int channel) {
    const float along = 0.06711056f * static_cast<float>(x + 23 * channel) +
                        0.00583715f * static_cast<float>(y + 47 * channel);
    const float scaled = 52.9829189f * (along - std::floor(along));
    return scaled - std::floor(scaled) - 0.5f;
}

/// The byte that is stored for a display value: floor(255 v + 0.5 + offset) with v cut to [0, 1]; 0 for NaN.
inline uint8_t displayByte(float v, float offset = 0.0f) {
    return v > 0.0f ? static_cast<uint8_t>(std::floor(255.0f * std::min(v, 1.0f) + 0.5f + offset))
                    : uint8_t{0};
}

/// The whole picture, 3 floats a pixel, row 0 at the top, on `threads` threads (0: all).
Image8 toneMapImage(const float* radianceRgb, int width, int height, const DisplayLook& look, int threads);

/// False colours, in [0, 1]. A unit vector: 0.5 v + 0.5, and black for the zero vector (nothing hit).
Vec3 normalColor(const Vec3& unitOrZero);
/// An id (0: nothing, black): a bright colour that differs clearly between neighbouring ids.
Vec3 idColor(uint32_t id);
/// A depth (0: nothing, black): near white, far dark, by 1 - 0.9 (depth - nearest) / (farthest - nearest).
Vec3 depthColor(float depth, float nearest, float farthest);

/// Smallest and largest positive depth; {0, 0} when there is none.
struct DepthRange {
    float nearest = 0.0f;
    float farthest = 0.0f;
};
DepthRange depthRange(const std::vector<float>& depths);

}  // namespace glint
