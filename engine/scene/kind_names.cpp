#include "engine/scene/kind_names.h"

#include "engine/scene/shape_forms.h"

namespace glint {

template <>
std::span<const KindName<ShapeKind>> kindNames<ShapeKind>() {
    static const std::vector<KindName<ShapeKind>> kNames = [] {
        std::vector<KindName<ShapeKind>> names;
        for (const ShapeForm& form : shapeForms()) {
            names.push_back({form.name, form.kind, form.help});
        }
        return names;
    }();
    return kNames;
}

template <>
std::span<const KindName<ProjectionKind>> kindNames<ProjectionKind>() {
    static constexpr KindName<ProjectionKind> kNames[] = {{"perspective", ProjectionKind::Perspective},
                                                          {"orthographic", ProjectionKind::Orthographic}};
    return kNames;
}

template <>
std::span<const KindName<CurveKind>> kindNames<CurveKind>() {
    static constexpr KindName<CurveKind> kNames[] = {{"bezier", CurveKind::Bezier},
                                                     {"bspline", CurveKind::Bspline}};
    return kNames;
}

template <>
std::span<const KindName<MaterialKind>> kindNames<MaterialKind>() {
    static constexpr KindName<MaterialKind> kNames[] = {
        {"diffuse", MaterialKind::Diffuse, "Lambert."},
        {"mirror", MaterialKind::Mirror, "Perfect reflection, tinted by color."},
        {"conductor", MaterialKind::Conductor, "A metal, by its name or by its constants."},
        {"dielectric", MaterialKind::Dielectric, "Glass."},
        {"plastic", MaterialKind::Plastic, "A diffuse base under a clear coat."},
        {"mixture", MaterialKind::Mixture, "A random choice of diffuse, mirror and refractive scattering."},
        {"translucent", MaterialKind::Translucent,
         "A thin sheet that reflects and lets through diffusely, on both sides alike: a leaf, paper."},
        {"principled", MaterialKind::Principled,
         "A clear coat over sheen over a base between plastic and metal: car paint, cloth, worn steel."},
        {"phong", MaterialKind::Phong,
         "The modified Phong model: diffuse, with a highlight that is a power of the cosine."},
        {"ward", MaterialKind::Ward, "Ward's model: diffuse, with an anisotropic highlight."},
        {"coated", MaterialKind::Coated,
         "A metal under a dielectric coat that may absorb: lacquered brass."}};
    return kNames;
}

template <>
std::span<const KindName<WardForm>> kindNames<WardForm>() {
    static constexpr KindName<WardForm> kNames[] = {
        {"ward", WardForm::Ward}, {"ward-duer", WardForm::Duer}, {"balanced", WardForm::Balanced}};
    return kNames;
}

template <>
std::span<const KindName<FacetDistribution>> kindNames<FacetDistribution>() {
    static constexpr KindName<FacetDistribution> kNames[] = {{"ggx", FacetDistribution::Ggx},
                                                             {"beckmann", FacetDistribution::Beckmann}};
    return kNames;
}

template <>
std::span<const KindName<LightKind>> kindNames<LightKind>() {
    static constexpr KindName<LightKind> kNames[] = {{"point", LightKind::Point},
                                                     {"spot", LightKind::Spot},
                                                     {"directional", LightKind::Directional},
                                                     {"projector", LightKind::Projector},
                                                     {"goniometric", LightKind::Goniometric}};
    return kNames;
}

template <>
std::span<const KindName<ColorEncoding>> kindNames<ColorEncoding>() {
    static constexpr KindName<ColorEncoding> kNames[] = {{"srgb", ColorEncoding::Srgb},
                                                         {"linear", ColorEncoding::Linear}};
    return kNames;
}

template <>
std::span<const KindName<WrapMode>> kindNames<WrapMode>() {
    static constexpr KindName<WrapMode> kNames[] = {
        {"repeat", WrapMode::Repeat}, {"clamp", WrapMode::Clamp}, {"mirror", WrapMode::Mirror}};
    return kNames;
}

template <>
std::span<const KindName<TexelFilter>> kindNames<TexelFilter>() {
    static constexpr KindName<TexelFilter> kNames[] = {{"bilinear", TexelFilter::Bilinear},
                                                       {"nearest", TexelFilter::Nearest},
                                                       {"mipmap", TexelFilter::Mipmap}};
    return kNames;
}

template <>
std::span<const KindName<TextureChannel>> kindNames<TextureChannel>() {
    static constexpr KindName<TextureChannel> kNames[] = {{"red", TextureChannel::Red},
                                                          {"green", TextureChannel::Green},
                                                          {"blue", TextureChannel::Blue},
                                                          {"alpha", TextureChannel::Alpha},
                                                          {"luminance", TextureChannel::Luminance}};
    return kNames;
}

template <>
std::span<const KindName<IntegratorKind>> kindNames<IntegratorKind>() {
    static const auto kNames = [] {
        std::vector<KindName<IntegratorKind>> names;
        names.reserve(std::size(kIntegratorTable));
        for (const IntegratorInfo& info : kIntegratorTable) {
            names.push_back({info.key, info.kind});
        }
        for (const IntegratorInfo& info : kIntegratorTable) {
            if (std::string_view(info.alias) != info.key) { names.push_back({info.alias, info.kind}); }
        }
        return names;
    }();
    return kNames;
}

template <>
std::span<const KindName<FilterKind>> kindNames<FilterKind>() {
    static constexpr KindName<FilterKind> kNames[] = {{"box", FilterKind::Box},
                                                      {"gaussian", FilterKind::Gaussian},
                                                      {"blackman-harris", FilterKind::BlackmanHarris}};
    return kNames;
}

template <>
std::span<const KindName<SamplerKind>> kindNames<SamplerKind>() {
    static constexpr KindName<SamplerKind> kNames[] = {{"sobol", SamplerKind::Sobol},
                                                       {"independent", SamplerKind::Independent}};
    return kNames;
}

template <>
std::span<const KindName<AcceleratorKind>> kindNames<AcceleratorKind>() {
    static constexpr KindName<AcceleratorKind> kNames[] = {{"bvh", AcceleratorKind::Bvh},
                                                           {"kdtree", AcceleratorKind::KdTree},
                                                           {"aabb", AcceleratorKind::Aabb},
                                                           {"none", AcceleratorKind::None}};
    return kNames;
}

template <>
std::span<const KindName<PhotonLookupKind>> kindNames<PhotonLookupKind>() {
    static constexpr KindName<PhotonLookupKind> kNames[] = {{"grid", PhotonLookupKind::Grid},
                                                            {"tree", PhotonLookupKind::Tree}};
    return kNames;
}

}  // namespace glint
