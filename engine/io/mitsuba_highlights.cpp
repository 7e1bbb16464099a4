// Mitsuba's phong and ward: models of a diffuse surface with a highlight.
#include <algorithm>

#include <fmt/format.h>

#include "engine/io/mitsuba_materials.h"
#include "engine/math/color.h"
#include "engine/scene/kind_names.h"

namespace glint {

/// As Mitsuba does, both are scaled where they would sum to more than 1.
void MitsubaMaterials::readReflectances(MitsubaObject* object, UvOrigin origin, Material* material) {
    const auto inputOf = [&](std::string_view name, float otherwise) {
        return mitsubaInput(object, {name}, SpectrumRole::Reflectance)
            .value_or(MitsubaInput{Vec3(otherwise), nullptr});
    };
    const MitsubaInput diffuse = inputOf("diffuse_reflectance", 0.5f);
    const MitsubaInput specular = inputOf("specular_reflectance", 0.2f);
    const auto mostOf = [this](const MitsubaInput& input) {
        return input.texture != nullptr ? textures_.mostOf(*input.texture) : input.color;
    };
    const float sum = maxComponent(mostOf(diffuse) + mostOf(specular));
    const bool isBounded = object->flag("ensure_energy_conservation", true);
    MitsubaTextures::Change change;
    if (sum > 1.0f && isBounded) {
        const float scale = 0.99f / sum;
        change = [scale](const Vec3& c) { return scale * c; };
    } else if (sum > 1.0f) {
        object->approximated("approximated: Phong's and Ward's models gain no light");
    }
    object->passOver({"specular_sampling_weight"});
    material->color = colorOf(diffuse, origin, change);
    material->specularReflectance = colorOf(specular, origin, change);
}

void MitsubaMaterials::readPhong(MitsubaObject* object, UvOrigin origin, MitsubaSurface* out) {
    Material& material = out->material;
    material.kind = MaterialKind::Phong;
    readReflectances(object, origin, &material);
    const auto exponent = mitsubaInput(object, {"exponent"}, SpectrumRole::Index);
    if (!exponent) { return; }
    material.exponent = exponent->texture != nullptr ? textures_.number(*exponent->texture, origin)
                                                     : NumberInput{std::clamp(exponent->color.x, 0.0f, 1e8f)};
}

void MitsubaMaterials::readWard(MitsubaObject* object, UvOrigin origin, MitsubaSurface* out) {
    Material& material = out->material;
    material.kind = MaterialKind::Ward;
    const std::string_view variant = object->text("variant", "balanced");
    if (const auto form = kindNamed<WardForm>(variant)) {
        material.wardForm = *form;
    } else {
        context_.fail(
            object->element(),
            fmt::format("the variant \"{}\" is unknown; expected ward, ward-duer or balanced", variant));
    }
    if (material.wardForm != WardForm::Balanced) {
        object->approximated("approximated: Ward's highlights gain no light at grazing angles");
    }
    readReflectances(object, origin, &material);
    readRoughness(object, origin, &material);
    material.distribution = FacetDistribution::Ggx;
}

}  // namespace glint
