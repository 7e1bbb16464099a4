#include "engine/io/mtl_glass.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>
#include <tiny_obj_loader.h>

namespace glint {
namespace {

/// Up to so opaque is glass, for Kd without and with a hue.
constexpr float kGreyGlass = 0.3f;
constexpr float kColouredGlass = 0.1f;
constexpr float kNear = 1e-3f;

bool hasLoneTr(const MtlEntry& entry) { return entry.has(MtlKey::Tr) && !entry.has(MtlKey::D); }

/// What d and Tr say; nothing: neither says anything.
std::optional<float> opacityOf(const MtlEntry& entry, const tinyobj::material_t& values, bool trIsOpacity) {
    if (entry.has(MtlKey::D)) {
        if (values.dissolve < 0.0f) { return std::nullopt; }
        const float d = std::min(values.dissolve, 1.0f);
        const bool contradicts = d <= kNear && entry.has(MtlKey::Tr) && entry.tr <= kNear;
        const bool isTextured = d <= kNear && entry.has(MtlKey::MapKd);
        return contradicts || isTextured ? 1.0f : d;
    }
    const bool says = hasLoneTr(entry) && entry.tr > kNear && entry.tr < 1.0f - kNear;
    if (!says) { return std::nullopt; }
    return trIsOpacity ? entry.tr : 1.0f - entry.tr;
}

Vec3 transmissionOf(const tinyobj::material_t& values) {
    const auto& tf = values.transmittance;
    return glm::clamp(Vec3(tf[0], tf[1], tf[2]), Vec3(0.0f), Vec3(1.0f));
}

bool isNearlyGrey(const Vec3& color) { return maxComponent(color) - minComponent(color) <= 0.02f; }

/// Of glass that d or illum 7 make: Tf where it is not black.
Vec3 tintOf(const MtlEntry& entry, const tinyobj::material_t& values) {
    const Vec3 tf = transmissionOf(values);
    return entry.has(MtlKey::Tf) && maxComponent(tf) > kNear ? tf : Vec3(1.0f);
}

/// Up to which opacity such a colour is glass.
float mostGlass(const MtlEntry& entry, const tinyobj::material_t& values) {
    const Vec3 color(values.diffuse[0], values.diffuse[1], values.diffuse[2]);
    const bool hasHue =
        entry.has(MtlKey::Kd) && maxComponent(color) - minComponent(color) > 0.1f * maxComponent(color);
    return hasHue ? kColouredGlass : kGreyGlass;
}

/// illum says glass, and nothing else says how much light passes.
MtlGlass byTransmission(const MtlEntry& entry, const tinyobj::material_t& values) {
    const std::string illum = fmt::format("illum {}", values.illum);
    if (!entry.has(MtlKey::Tf)) {
        const bool bends = !entry.has(MtlKey::Ni) || values.ior > 1.0f + kNear;
        return {.isGlass = bends && !entry.has(MtlKey::MapKd), .why = illum};
    }
    const Vec3 tf = transmissionOf(values);
    const std::string why = fmt::format("{}, Tf {} {} {}", illum, tf.x, tf.y, tf.z);
    if (isNearlyGrey(tf)) {
        const bool isGlass = tf.x <= mostGlass(entry, values);
        return {.isGlass = isGlass, .why = why, .opacity = isGlass ? 1.0f : tf.x};
    }
    return {.isGlass = true, .tint = tf, .why = why};
}

}  // namespace

bool trIsOpacity(const std::vector<MtlEntry>& entries) {
    const auto opaque = std::ranges::count_if(
        entries, [](const MtlEntry& entry) { return hasLoneTr(entry) && entry.tr >= 1.0f - kNear; });
    const auto transparent = std::ranges::count_if(
        entries, [](const MtlEntry& entry) { return hasLoneTr(entry) && entry.tr <= kNear; });
    return opaque > transparent;
}

MtlGlass glassOf(const MtlEntry& entry, const tinyobj::material_t& values, bool trIsOpacity) {
    const int illum = values.illum;
    const bool claims = entry.has(MtlKey::Illum) && (illum == 4 || illum == 6 || illum == 7 || illum == 9);
    const std::string claim = claims ? fmt::format("illum {}", illum) : "";
    if (entry.has(MtlKey::MapD)) { return {.why = claim}; }
    const std::optional<float> opacity = opacityOf(entry, values, trIsOpacity);
    if (entry.has(MtlKey::Pm) && values.metallic >= 0.5f) {
        return {.why = claim, .opacity = opacity.value_or(1.0f)};
    }
    if (opacity && *opacity <= mostGlass(entry, values)) {
        const bool byD = entry.has(MtlKey::D);
        return {.isGlass = true,
                .tint = tintOf(entry, values),
                .why = fmt::format("{} {}", byD ? "d" : "Tr", byD ? *opacity : entry.tr)};
    }
    const bool isPartly = opacity && *opacity < 1.0f - kNear;
    const bool refracts = claims && (illum == 6 || illum == 7) && values.ior > 1.0f + kNear && !isPartly;
    if (refracts && entry.has(MtlKey::Ni) && !entry.has(MtlKey::MapKd)) {
        return {.isGlass = true,
                .tint = tintOf(entry, values),
                .why = fmt::format("{} with Ni {}", claim, values.ior)};
    }
    if (claims && !opacity) { return byTransmission(entry, values); }
    const bool writtenTransparent = entry.has(MtlKey::D) && values.dissolve <= 0.5f;
    const bool doubtfulTr = hasLoneTr(entry) && entry.tr >= 1.0f - kNear;
    return {.why = writtenTransparent ? fmt::format("d {}", values.dissolve)
                   : doubtfulTr       ? "Tr 1 alone"
                                      : claim,
            .opacity = opacity.value_or(1.0f)};
}

}  // namespace glint
