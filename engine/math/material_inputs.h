// What a material's models compute with beside its colour, listed once: descriptions hold constants or
// textures of these, tables of kernels texture indices, and models plain numbers.
//
// A new one is a member, a line below, and its use in a model (kernels/bsdf/). Of one that is
// described here, the field in scene files, their schema and the window's row follow; others have a
// line in scene/scene_fields.h.
#pragma once

#include <type_traits>

#include "engine/base/host_device.h"
#include "engine/base/kinds.h"
#include "engine/math/vec.h"

namespace glint {

/// Color and Number: what stands for three numbers and for one, made from a default.
template <class Color, class Number>
struct MaterialInputs {
    /// conductor, coated, without a metal name: index of refraction at R, G, B
    Color eta{Vec3(0.2f)};
    /// likewise: extinction at R, G, B
    Color k{Vec3(3.9f)};
    /// dielectric, plastic, mixture, principled: interior over exterior index of refraction, > 0. Coated: of
    /// the coat
    Number ior{1.5f};
    /// conductor, dielectric, plastic, principled, coated: alpha of the (metal's) facets in [0, 1]; below
    /// kSmoothAlpha: smooth.
    /// Ward: of the half vector's slope, at least kSmoothAlpha
    Number roughness{0.0f};
    /// likewise: alpha across the direction of `roughness`; negative: the same
    Number crossRoughness{-1.0f};
    /// likewise: that direction in the plane of dpdu (x) and dpdv (y), coded: 0.5 stands for 0
    Color anisotropyDirection{Vec3(1.0f, 0.5f, 0.5f)};
    /// mixture: diffuse, mirror, refractive; not negative, not all zero
    Color mixtureWeights{Vec3(1.0f, 0.0f, 0.0f)};
    /// translucent: what passes, diffusely; with the colour at most 1
    Color transmission{Vec3(0.25f)};
    /// Phong, Ward: of the highlight; what it sums with the colour to beyond 1 is scaled, both alike
    Color specularReflectance{Vec3(0.2f)};
    /// Phong: of the highlight, which is the narrower, the larger it is
    Number exponent{30.0f};
    /// coated: optical depth straight through the coat, in one direction
    Color coatAbsorption{Vec3(0.0f)};
    /// principled, all from here on, in [0, 1]: between plastic and a metal whose reflectance is the colour
    Number metallic{0.0f};
    Number specularTransmission{0.0f};  ///< share of what enters the dielectric that passes it
    Number specular{1.0f};              ///< factor on what the dielectric's boundary reflects
    Color specularTint{Vec3(1.0f)};     ///< likewise, but for grazing incidence
    Number clearcoat{0.0f};             ///< share of the surface that is coated
    Number clearcoatRoughness{0.0f};    ///< GGX alpha; below kSmoothAlpha: smooth. Coated, too
    Color sheenColor{Vec3(0.0f)};
    Number sheenRoughness{0.3f};  ///< the smaller, the more at grazing incidence alone

    bool operator==(const MaterialInputs&) const = default;
};

/// What is true of an input whatever its value.
struct InputInfo {
    const char* key;                 ///< in scene files
    float least, most;               ///< the numbers are clamped to these, those of textures included
    uint32_t kinds;                  ///< models that look at it: kindBit()
    bool isReplacedByMetal = false;  ///< a conductor's metal says what it is
    bool isReplacedByGlass = false;  ///< a dielectric's glass does
    bool canBeMissing = false;       ///< a negative constant says so
    const char* help = nullptr;      ///< of one that is described here: in lower case without a full stop
};

constexpr uint32_t kindBit(MaterialKind kind) { return 1u << static_cast<uint32_t>(kind); }

/// A type as a value.
template <class SomeType>
struct TypeTag {
    using Type = SomeType;
};

/// One input: memberIn(TypeTag<Set>()) points to that of a set, which has a member for each.
template <class MemberIn>
struct ModelInput {
    InputInfo info;
    MemberIn memberIn;

    template <class Visit, class... Sets>
    GLINT_HD constexpr void visitIn(const Visit& visit, Sets&... sets) const {
        visit(info, sets.*memberIn(TypeTag<std::remove_const_t<Sets>>())...);
    }
};
template <class MemberIn>
ModelInput(InputInfo, MemberIn) -> ModelInput<MemberIn>;

/// combine(input...) with every ModelInput that is described here; their numbers are from 0 to 1.
template <class Combine>
GLINT_HD constexpr auto withDescribedInputs(const Combine& combine) {
    constexpr uint32_t kPrincipled = kindBit(MaterialKind::Principled);
    constexpr uint32_t kCoated = kindBit(MaterialKind::Coated);
    const auto described = [](const char* key, uint32_t kinds, const char* help) {
        return InputInfo{.key = key, .least = 0.0f, .most = 1.0f, .kinds = kinds, .help = help};
    };
    return combine(
        ModelInput{described("specular", kPrincipled, "factor on what plastic reflects at its boundary"),
                   [](auto set) { return &decltype(set)::Type::specular; }},
        ModelInput{described("specularTint", kPrincipled,
                             "likewise, but for grazing incidence, where reflection stays white"),
                   [](auto set) { return &decltype(set)::Type::specularTint; }},
        ModelInput{
            described("clearcoat", kPrincipled, "share of the surface that has a clear coat of index 1.5"),
            [](auto set) { return &decltype(set)::Type::clearcoat; }},
        ModelInput{described("clearcoatRoughness", kPrincipled | kCoated, "GGX alpha of the coat; 0: smooth"),
                   [](auto set) { return &decltype(set)::Type::clearcoatRoughness; }},
        ModelInput{described("sheenColor", kPrincipled,
                             "of light that fibres scatter at grazing incidence; 0: none"),
                   [](auto set) { return &decltype(set)::Type::sheenColor; }},
        ModelInput{
            described("sheenRoughness", kPrincipled, "0.05 and less: at the edges alone; 1: everywhere"),
            [](auto set) { return &decltype(set)::Type::sheenRoughness; }});
}

/// combine(input...) with every ModelInput.
template <class Combine>
GLINT_HD constexpr auto withModelInputs(const Combine& combine) {
    constexpr uint32_t kConductor = kindBit(MaterialKind::Conductor);
    constexpr uint32_t kDielectric = kindBit(MaterialKind::Dielectric);
    constexpr uint32_t kPlastic = kindBit(MaterialKind::Plastic);
    constexpr uint32_t kMixture = kindBit(MaterialKind::Mixture);
    constexpr uint32_t kTranslucent = kindBit(MaterialKind::Translucent);
    constexpr uint32_t kPrincipled = kindBit(MaterialKind::Principled);
    constexpr uint32_t kPhong = kindBit(MaterialKind::Phong);
    constexpr uint32_t kWard = kindBit(MaterialKind::Ward);
    constexpr uint32_t kCoated = kindBit(MaterialKind::Coated);
    constexpr uint32_t kMetal = kConductor | kCoated;
    constexpr uint32_t kRough = kMetal | kDielectric | kPlastic | kPrincipled | kWard;
    constexpr uint32_t kRefractive = kDielectric | kPlastic | kMixture | kPrincipled | kCoated;
    constexpr float kMost = 1e18f;
    return withDescribedInputs([&](const auto&... described) {
        return combine(ModelInput{InputInfo{"eta", 0.0f, kMost, kMetal, true},
                                  [](auto set) { return &decltype(set)::Type::eta; }},
                       ModelInput{InputInfo{"k", 0.0f, kMost, kMetal, true},
                                  [](auto set) { return &decltype(set)::Type::k; }},
                       ModelInput{InputInfo{"ior", 1e-3f, 1e3f, kRefractive, false, true},
                                  [](auto set) { return &decltype(set)::Type::ior; }},
                       ModelInput{InputInfo{"roughness", 0.0f, 1.0f, kRough},
                                  [](auto set) { return &decltype(set)::Type::roughness; }},
                       ModelInput{InputInfo{"crossRoughness", 0.0f, 1.0f, kRough, false, false, true},
                                  [](auto set) { return &decltype(set)::Type::crossRoughness; }},
                       ModelInput{InputInfo{"anisotropyDirection", 0.0f, 1.0f, kRough},
                                  [](auto set) { return &decltype(set)::Type::anisotropyDirection; }},
                       ModelInput{InputInfo{"weights", 0.0f, kMost, kMixture},
                                  [](auto set) { return &decltype(set)::Type::mixtureWeights; }},
                       ModelInput{InputInfo{"transmission", 0.0f, 1.0f, kTranslucent},
                                  [](auto set) { return &decltype(set)::Type::transmission; }},
                       ModelInput{InputInfo{"specularReflectance", 0.0f, 1.0f, kPhong | kWard},
                                  [](auto set) { return &decltype(set)::Type::specularReflectance; }},
                       ModelInput{InputInfo{"exponent", 0.0f, 1e8f, kPhong},
                                  [](auto set) { return &decltype(set)::Type::exponent; }},
                       ModelInput{InputInfo{"coatAbsorption", 0.0f, kMost, kCoated},
                                  [](auto set) { return &decltype(set)::Type::coatAbsorption; }},
                       ModelInput{InputInfo{"metallic", 0.0f, 1.0f, kPrincipled},
                                  [](auto set) { return &decltype(set)::Type::metallic; }},
                       ModelInput{InputInfo{"specularTransmission", 0.0f, 1.0f, kPrincipled},
                                  [](auto set) { return &decltype(set)::Type::specularTransmission; }},
                       described...);
    });
}

/// Calls visit(info, input...) for each input, with that of each of the `sets`.
template <class Visit, class... Sets>
GLINT_HD constexpr void forEachModelInput(const Visit& visit, Sets&... sets) {
    withModelInputs([&](const auto&... input) { (input.visitIn(visit, sets...), ...); });
}

}  // namespace glint
