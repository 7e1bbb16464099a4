// What of a description is used at all: what no object refers to is neither read nor built, and does not
// change the picture's fingerprint.
//
// References that are out of range are passed over; validateScene() refuses them.
#pragma once

#include <vector>

#include "engine/scene/scene_fields.h"

namespace glint {

/// Calls visit(traits, input) for each input of a material, a ColorInput& or a NumberInput&, with the
/// FieldTraits of its field.
template <class AnyMaterial, class Visit>
void forEachInput(AnyMaterial& material, const Visit& visit) {
    forEachField<Material>([&]<class Member>(const Field<Material, Member>& field) {
        if constexpr (kIsInput<Member>) { visit(field.traits, material.*field.member); }
    });
}

/// The texture indices of a material's inputs, in the order of forEachInput(); -1 where there is none.
std::vector<int> inputTextures(const Material& material);
/// The places of the same indices, for changing them.
std::vector<int*> inputTextures(Material* material);
/// The textures of those inputs that the material's kind looks at.
std::vector<int> usedTextures(const Material& material);

/// For each material whether an object has it.
std::vector<bool> usedMaterials(const SceneDescription& scene);
/// For each texture whether one of those materials has it.
std::vector<bool> usedTextures(const SceneDescription& scene);
/// Whether the light is of a kind that has a picture, and that is an image.
bool showsImage(const Light& light);
/// For each mesh whether an object places it.
std::vector<bool> usedMeshes(const SceneDescription& scene);
/// For each mesh whether an object places it with a texture, or with facets that lie along u: only then are
/// its uvs read.
std::vector<bool> texturedMeshes(const SceneDescription& scene);
/// Whether the environment shines with an image.
bool usesEnvironmentImage(const SceneDescription& scene);
/// Whether anything shines: a material that an object has, a light, or the environment.
bool hasLight(const SceneDescription& scene);

}  // namespace glint
