// One function per part of the scene; each stops at the first fault.
#include "engine/builders/scene_validation.h"

#include <fmt/format.h>

#include "engine/builders/light_validation.h"
#include "engine/builders/scene_fault.h"
#include "engine/scene/glasses.h"
#include "engine/scene/metals.h"
#include "engine/scene/profile.h"
#include "engine/scene/scene_use.h"

namespace glint {
namespace {

Status checkCamera(const Camera& camera) {
    const Vec3 view = camera.target - camera.position;
    if (!isFinite(camera.position) || !isFinite(camera.target) || !isFinite(camera.up)) {
        return fault("camera", "position, target and up must be finite numbers");
    }
    if (lengthSquared(view) == 0.0f) {
        return fault("camera", "position and target are the same point, so it looks nowhere");
    }
    if (!inRange(camera.verticalFovDeg, 1e-6f, 179.999f)) {
        return fault(
            "camera",
            fmt::format("the vertical field of view is {} degrees; expected more than 0 and less than 180",
                        camera.verticalFovDeg));
    }
    if (!inRange(camera.viewHeight, 1e-30f, 1e30f)) {
        return fault("camera", fmt::format("the view is {} m high; expected more than 0", camera.viewHeight));
    }
    if (!inRange(camera.shift.x, -1e6f, 1e6f) || !inRange(camera.shift.y, -1e6f, 1e6f)) {
        return fault("camera", fmt::format("the shift is {}, {} heights of the picture; expected at most 1e6",
                                           camera.shift.x, camera.shift.y));
    }
    if (!inRange(camera.horizontalScale, 1e-6f, 1e6f)) {
        return fault("camera", fmt::format("the horizontal scale is {}; expected a positive number",
                                           camera.horizontalScale));
    }
    if (!inRange(camera.apertureDiameter, 0.0f, 1e30f)) {
        return fault("camera",
                     fmt::format("the aperture is {} m; expected 0 or more", camera.apertureDiameter));
    }
    if (!inRange(camera.focalDistance, 1e-30f, 1e30f)) {
        return fault("camera",
                     fmt::format("the focal distance is {} m; expected more than 0", camera.focalDistance));
    }
    if (camera.apertureBlades < 0 || camera.apertureBlades == 1 || camera.apertureBlades == 2 ||
        !std::isfinite(camera.bladeRotationDeg)) {
        return fault("camera", fmt::format("{} aperture blades; expected 0 (round) or at least 3",
                                           camera.apertureBlades));
    }
    return {};
}

Status checkImage(const Resolution& size, const RenderOptions& options) {
    if (size.width < 1 || size.height < 1 || size.width > kMaxResolution || size.height > kMaxResolution) {
        return fault("resolution", fmt::format("{}x{} pixels; expected 1 to {} each way", size.width,
                                               size.height, kMaxResolution));
    }
    if (options.maxDepth < 0 || options.rouletteStartDepth < 0) {
        return fault("options", "depths must be 0 or more");
    }
    if (!inRange(options.filterRadius, 1e-3f, 16.0f)) {
        return fault("options", fmt::format("the filter radius is {} pixels; expected 0.001 to 16",
                                            options.filterRadius));
    }
    if (!inRange(options.fireflyClamp, 0.0f, 3e38f)) {
        return fault("options", "the firefly clamp must be 0 (off) or more");
    }
    return {};
}

Status checkPhotons(const SppmOptions& sppm) {
    if (sppm.photonsPerPass < 1) {
        return fault("sppm", "there are 0 photons in a pass; expected 1 or more");
    }
    if (!(sppm.alpha > 0.0f && sppm.alpha < 1.0f)) {
        return fault("sppm", fmt::format("alpha is {}; expected a number between 0 and 1", sppm.alpha));
    }
    if (!inRange(sppm.radiusWorld, 0.0f, 1e18f)) {
        return fault("sppm",
                     fmt::format("the radius is {} m; expected 0 (automatic) or more", sppm.radiusWorld));
    }
    if (!(sppm.radiusFootprints > 0.0f && sppm.radiusFootprints <= 1e6f)) {
        return fault("sppm", fmt::format("the automatic radius is {} footprints; expected more than 0",
                                         sppm.radiusFootprints));
    }
    if (!inRange(sppm.storeRoughness, 0.0f, 1.0f)) {
        return fault("sppm",
                     fmt::format("the roughness that stores is {}; expected 0 to 1", sppm.storeRoughness));
    }
    return {};
}

Status checkInputs(const SceneDescription& scene, const Material& material, const std::string& who) {
    Status status;
    forEachInput(material, [&](const FieldTraits&, const auto& input) {
        if (!status || input.texture == -1) { return; }
        if (input.texture < -1 || input.texture >= static_cast<int>(scene.textures.size())) {
            status = fault(who, fmt::format("uses texture {} of {}", input.texture, scene.textures.size()));
        }
    });
    return status;
}

Status checkMaterial(const SceneDescription& scene, size_t index) {
    const Material& material = scene.materials[index];
    const std::string who = label("material", material.name, index);
    if (Status status = checkInputs(scene, material, who); !status) { return status; }
    if (!notNegative(material.color.value)) { return fault(who, "the colour must not be negative"); }
    if (!notNegative(material.emission.value) || !inRange(material.emissionStrength, 0.0f, 3e38f)) {
        return fault(who, "the emission must not be negative");
    }
    if (!inRange(material.roughness.value, 0.0f, 1.0f)) {
        return fault(who, fmt::format("the roughness is {}; expected 0 to 1", material.roughness.value));
    }
    const float across = material.crossRoughness.value;
    if (hasCrossRoughness(material) &&
        !inRange(across, material.crossRoughness.texture < 0 ? 0.0f : -1.0f, 1.0f)) {
        return fault(who, fmt::format("the roughness across is {}; expected 0 to 1", across));
    }
    if (!std::isfinite(material.anisotropyRotationDeg)) {
        return fault(who, "the rotation of the anisotropy must be a finite number");
    }
    if (!inRange(material.ior.value, 1e-3f, 1e3f)) {
        return fault(who,
                     fmt::format("the index of refraction is {}; expected more than 0", material.ior.value));
    }
    if (!inRange(material.opacity.value, 0.0f, 1.0f)) {
        return fault(who, fmt::format("the opacity is {}; expected 0 to 1", material.opacity.value));
    }
    if (!std::isfinite(material.bumpHeight) || !std::isfinite(material.normalStrength) ||
        !isFinite(material.normalMap.value)) {
        return fault(who, "bump height, normal map and its strength must be finite numbers");
    }
    if (hasMetal(material) && !material.metal.empty() && !findMetal(material.metal)) {
        return fault(who, fmt::format("\"{}\" is not a known metal", material.metal));
    }
    if (hasGlass(material) && !material.glass.empty() && !findGlass(material.glass)) {
        return fault(who, fmt::format("\"{}\" is not a known glass", material.glass));
    }
    if (!notNegative(material.iorRgb) || !inRange(material.abbeNumber, 0.0f, 1e6f)) {
        return fault(who, "iorRgb and the Abbe number must not be negative");
    }
    if (!notNegative(material.attenuationColor) || maxComponent(material.attenuationColor) > 1.0f ||
        !inRange(material.attenuationDistance, 1e-30f, 1e30f)) {
        return fault(who, "the attenuation colour must be 0 to 1 and its distance more than 0");
    }
    if (!notNegative(material.eta.value) || !notNegative(material.k.value) ||
        !notNegative(material.coatAbsorption.value)) {
        return fault(who, "eta, k and a coat's absorption must not be negative");
    }
    if (material.kind == MaterialKind::Mixture &&
        (!notNegative(material.mixtureWeights.value) || isZero(material.mixtureWeights.value))) {
        return fault(who, "the mixture's weights must not be negative and not all zero");
    }
    return {};
}

Status checkMesh(const SceneDescription& scene, size_t index, bool isPlaced) {
    const Mesh& mesh = scene.meshes[index];
    const std::string who = label("mesh", mesh.name, index);
    if (!mesh.data) {
        return isPlaced ? fault(who, "an object places it, but its triangles have not been read") : Status();
    }
    const MeshData& data = *mesh.data;
    const size_t vertices = data.positions.size();
    const auto fits = [&](size_t count) { return count == 0 || count == vertices; };
    if (data.indices.size() % 3 != 0 || !fits(data.normals.size()) || !fits(data.uvs.size()) ||
        !fits(data.colors.size()) || !fits(data.tangents.size())) {
        return fault(who, "its arrays do not have one entry per vertex and three indices per triangle");
    }
    return {};
}

Status checkObject(const SceneDescription& scene, size_t index) {
    const Object& object = scene.objects[index];
    const std::string who = label("object", object.name, index);
    if (object.material < 0 || object.material >= static_cast<int>(scene.materials.size())) {
        return fault(who, fmt::format("uses material {} of {}", object.material, scene.materials.size()));
    }
    if (object.shape == ShapeKind::Mesh &&
        (object.mesh < 0 || object.mesh >= static_cast<int>(scene.meshes.size()))) {
        return fault(who, fmt::format("uses mesh {} of {}", object.mesh, scene.meshes.size()));
    }
    if (object.shape == ShapeKind::Revolved) {
        if (const std::string problem = profileFault(object); !problem.empty()) {
            return fault(who, problem);
        }
    }
    if (!isInvertible(object.objectToWorld)) {
        return fault(who, "its transform flattens it or holds numbers that are not finite");
    }
    return {};
}

/// The first fault that check(index) finds.
template <class Check>
Status checkAll(size_t count, const Check& check) {
    for (size_t index = 0; index < count; ++index) {
        if (Status status = check(index); !status) { return status; }
    }
    return {};
}

}  // namespace

Status validateScene(const SceneDescription& scene, EditKind kinds) {
    if (Status status = checkCamera(scene.camera); !status) { return status; }
    if (Status status = checkImage(scene.resolution, scene.options); !status) { return status; }
    if (Status status = checkPhotons(scene.sppm); !status) { return status; }
    const auto concerns = [kinds](EditKind some) { return has(kinds, some | EditKind::Everything); };
    if (concerns(EditKind::MaterialParameters | EditKind::MaterialKind)) {
        const auto check = [&](size_t i) { return checkMaterial(scene, i); };
        if (Status status = checkAll(scene.materials.size(), check); !status) { return status; }
    }
    if (concerns(EditKind::ObjectTransform | EditKind::MaterialKind)) {
        const auto check = [&](size_t i) { return checkObject(scene, i); };
        if (Status status = checkAll(scene.objects.size(), check); !status) { return status; }
    }
    if (concerns(EditKind::Everything)) {
        const std::vector<bool> placed = usedMeshes(scene);
        const auto check = [&](size_t i) { return checkMesh(scene, i, placed[i]); };
        if (Status status = checkAll(scene.meshes.size(), check); !status) { return status; }
    }
    if (concerns(EditKind::Lights)) {
        const auto check = [&](size_t i) { return checkLight(scene, i); };
        if (Status status = checkAll(scene.lights.size(), check); !status) { return status; }
    }
    return checkEnvironment(scene);
}

}  // namespace glint
