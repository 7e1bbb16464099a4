// Editable materials. Plain data: what the panels edit and the scene files hold.
//
// Deliberately left out: node graphs, layers beyond one coat, subsurface and volumes that scatter.
#pragma once

#include <cstdint>
#include <string>
#include <type_traits>

#include "engine/base/kinds.h"
#include "engine/math/material_inputs.h"
#include "engine/math/vec.h"

namespace glint {

/// A linear colour, or an image that replaces it.
struct ColorInput {
    Vec3 value{0.5f};
    int texture = -1;  ///< index into SceneDescription::textures, or -1

    bool operator==(const ColorInput&) const = default;
};

/// A number, or an image that replaces it.
struct NumberInput {
    float value = 0.0f;
    int texture = -1;  ///< index into SceneDescription::textures, or -1

    bool operator==(const NumberInput&) const = default;
};

/// The coded normal of a surface as it is.
constexpr Vec3 kNoTilt{0.5f, 0.5f, 1.0f};

/// What its model computes with beside the colour is in MaterialInputs.
struct Material : MaterialInputs<ColorInput, NumberInput> {
    std::string name;
    MaterialKind kind = MaterialKind::Diffuse;

    /// Diffuse, plastic, Phong, Ward: albedo of diffuse reflection. Translucent: what it reflects. Mirror:
    /// reflectance. Dielectric: tint of what passes and reflects. Mixture: all three. Conductor, coated: a
    /// factor on the metal's reflectance, 1 by default. Principled: albedo of plastic, reflectance of metal,
    /// tint of what passes. Range [0, 1].
    ColorInput color;

    std::string metal = "gold";  ///< conductor, coated: measured constants by name (metals.h); empty: use
                                 ///< eta and k
    std::string glass;  ///< dielectric, mixture: measured indices by name (glasses.h); empty: those below
    /// dielectric, mixture: index at red, green and blue, for pictures of three wavelengths; 0: use ior
    Vec3 iorRgb{0.0f};
    /// dielectric, mixture: Abbe number of `ior`, by how much colours are bent alike; 0: all are
    float abbeNumber = 0.0f;
    bool thin = false;  ///< dielectric, principled that light passes: a sheet instead of a body
    /// principled that light passes: it is tinted by the root of the colour, so that a way in and out of a
    /// body makes the colour
    bool rootTint = false;
    WardForm wardForm = WardForm::Balanced;  ///< Ward only
    /// conductor, dielectric, plastic: of the facets of what is rough
    FacetDistribution distribution = FacetDistribution::Ggx;
    /// turns the direction of `roughness` counter-clockwise from dpdu to dpdv, seen where these turn so
    float anisotropyRotationDeg = 0.0f;
    /// of a body that light passes: the share of light that is left after attenuationDistance inside, per
    /// channel. A millionth at least
    Vec3 attenuationColor{1.0f};
    float attenuationDistance = 1.0f;  ///< metres, > 0

    NumberInput bump;          ///< height map: a texture; a constant height changes nothing
    float bumpHeight = 0.01f;  ///< metres that a height of 1 stands for; negative: valleys
    /// tangent-space normal, coded: x to the image's right, y to its top, z outwards, 0.5 stands for 0
    ColorInput normalMap{kNoTilt};
    float normalStrength = 1.0f;  ///< multiplies x and y of the normal map

    NumberInput opacity{1.0f};  ///< share of the surface that is there, [0, 1]: rays pass the rest
    bool alphaCutsOut = true;   ///< the alpha of the colour's image is a factor on the opacity

    ColorInput emission{Vec3(0.0f)};  ///< radiance factor, W/(sr m^2) per channel
    float emissionStrength = 1.0f;    ///< multiplies `emission`
    bool emitsBothSides = false;      ///< otherwise only the side the geometric normal points to

    Vec3 phongSpecular{0.0f};     ///< of the highlight in ray casting, which alone looks at it
    float phongExponent = 20.0f;  ///< likewise: larger is smaller

    bool emissive() const {
        return emissionStrength > 0.0f && (emission.texture >= 0 || maxComponent(emission.value) > 0.0f);
    }

    bool operator==(const Material&) const = default;
};

/// Whether it is principled and some light passes it.
inline bool transmits(const Material& material) {
    return material.kind == MaterialKind::Principled &&
           (material.specularTransmission.texture >= 0 || material.specularTransmission.value > 0.0f);
}

/// Whether light goes in and out of it, so that it has an inside which can absorb.
inline bool isClearBody(const Material& material) {
    return (material.kind == MaterialKind::Dielectric || transmits(material)) && !material.thin;
}

template <class Value>
constexpr bool kIsInput = std::is_same_v<Value, ColorInput> || std::is_same_v<Value, NumberInput>;

/// Whether it has the fields of a glass that colours pass alike or apart.
inline bool hasGlass(const Material& material) {
    return material.kind == MaterialKind::Dielectric || material.kind == MaterialKind::Mixture;
}

/// What a body absorbs per metre of a way inside; a millionth of the light is the least that is left after
/// the attenuation distance.
inline Vec3 absorptionOf(const Material& material) {
    Vec3 absorption(0.0f);
    for (int channel = 0; channel < 3 && isClearBody(material); ++channel) {
        const float left = clampf(material.attenuationColor[channel], 1e-6f, 1.0f);
        if (left < 1.0f) { absorption[channel] = -std::log(left) / material.attenuationDistance; }
    }
    return absorption;
}

/// Whether it has the fields of a metal.
inline bool hasMetal(const Material& material) {
    return material.kind == MaterialKind::Conductor || material.kind == MaterialKind::Coated;
}

/// Whether something else than `ior` says what its index is.
inline bool replacesIor(const Material& material) {
    return hasGlass(material) && (!material.glass.empty() || !isZero(material.iorRgb));
}

/// Whether it is rough by an alpha, or by two.
inline bool hasFacets(MaterialKind kind) {
    return kind == MaterialKind::Conductor || kind == MaterialKind::Dielectric ||
           kind == MaterialKind::Plastic || kind == MaterialKind::Principled || kind == MaterialKind::Ward ||
           kind == MaterialKind::Coated;
}

/// Principled materials are defined with GGX, and Ward's have a distribution of their own.
inline FacetDistribution distributionOf(const Material& material) {
    const bool isDefined = material.kind == MaterialKind::Principled || material.kind == MaterialKind::Ward;
    return isDefined ? FacetDistribution::Ggx : material.distribution;
}

/// Whether a roughness across is given.
inline bool hasCrossRoughness(const Material& material) {
    return material.crossRoughness.texture >= 0 || material.crossRoughness.value >= 0.0f;
}

/// Whether it differs from the one along, or may do.
inline bool isAnisotropic(const Material& material) {
    return hasFacets(material.kind) && hasCrossRoughness(material) &&
           material.crossRoughness != material.roughness;
}

/// Whether its boundary has a table of albedos: CoatRow.
inline bool hasCoatTable(MaterialKind kind) {
    return kind == MaterialKind::Plastic || kind == MaterialKind::Principled;
}

/// Whether the material's model looks at an input.
inline bool looksAt(const Material& material, const InputInfo& info) {
    return (info.kinds & kindBit(material.kind)) != 0 &&
           !(info.isReplacedByMetal && !material.metal.empty()) &&
           !(info.isReplacedByGlass && replacesIor(material));
}

}  // namespace glint
