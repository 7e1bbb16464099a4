// What pbrt's homogeneous media absorb within glass.
#include "engine/io/pbrt_materials.h"

namespace glint {

void PbrtMaterials::defineMedium(const std::string& name, const PbrtParams& params) {
    Vec3& absorption = media_[name] = Vec3(0.0f);
    if (params.text("type") != "homogeneous") {
        params.approximated("media that are not alike all over are left out");
        return;
    }
    const auto coefficient = [&](std::string_view key, const Vec3& usual) {
        const auto given = textures_.color(params, key, SpectrumRole::Index);
        return given ? given->value : usual;
    };
    if (params.has("preset")) { params.approximated("approximated: named media are pbrt's usual one"); }
    absorption = params.number("scale", 1.0f, 0.0f) * coefficient("sigma_a", Vec3(0.0011f, 0.0024f, 0.014f));
    constexpr float kNone = 1e-3f;
    if (maxComponent(coefficient("sigma_s", Vec3(2.55f, 3.21f, 3.77f))) > kNone) {
        params.approximated("approximated: media absorb, but scatter nothing");
    }
    params.passOver({"g", "Le", "Lescale"});
    params.finish();
}

Vec3 PbrtMaterials::absorptionIn(int number, const std::string& medium, const PbrtParams& at) {
    const auto found = media_.find(medium);
    if (found == media_.end()) {
        at.fail("there is no medium \"" + medium + "\"");
        return Vec3(0.0f);
    }
    const PbrtSurface& surface = surfaceOf(number);
    const Material& material = surface.material;
    if (surface.isThere && isClearBody(material)) { return found->second; }
    at.approximated("media are left out but within glass");
    return Vec3(0.0f);
}

}  // namespace glint
