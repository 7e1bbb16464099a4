#include "viewer/window/scene_diff.h"

#include "engine/scene/scene_use.h"

namespace glint {
namespace {

bool sameCamera(const Camera& a, const Camera& b) {
    return a.position == b.position && a.target == b.target && a.up == b.up &&
           a.verticalFovDeg == b.verticalFovDeg && a.horizontalScale == b.horizontalScale &&
           a.apertureDiameter == b.apertureDiameter && a.focalDistance == b.focalDistance &&
           a.apertureBlades == b.apertureBlades && a.bladeRotationDeg == b.bladeRotationDeg;
}

bool sameParameters(const Material& a, const Material& b) {
    return a.color.value == b.color.value && a.metal == b.metal && a.eta.value == b.eta.value &&
           a.k.value == b.k.value && a.ior.value == b.ior.value && a.roughness.value == b.roughness.value &&
           a.thin == b.thin && a.mixtureWeights.value == b.mixtureWeights.value &&
           a.emission.value == b.emission.value && a.emissionStrength == b.emissionStrength &&
           a.emitsBothSides == b.emitsBothSides;
}

EditKind materialDifferences(const std::vector<Material>& before, const std::vector<Material>& after) {
    if (before.size() != after.size()) { return EditKind::Everything; }
    EditKind kinds = EditKind::None;
    for (size_t i = 0; i < before.size(); ++i) {
        const bool sameKind =
            before[i].kind == after[i].kind && inputTextures(before[i]) == inputTextures(after[i]);
        if (!sameKind) { kinds |= EditKind::MaterialKind; }
        if (!sameParameters(before[i], after[i])) { kinds |= EditKind::MaterialParameters; }
    }
    return kinds;
}

bool sameLight(const Light& a, const Light& b) {
    return a.kind == b.kind && a.position == b.position && a.direction == b.direction && a.color == b.color &&
           a.strength == b.strength && a.coneAngleDeg == b.coneAngleDeg &&
           a.coneFalloffStartDeg == b.coneFalloffStartDeg;
}

bool sameLights(const SceneDescription& a, const SceneDescription& b) {
    const Environment& e = a.environment;
    const Environment& f = b.environment;
    if (e.color != f.color || e.strength != f.strength || e.image != f.image ||
        e.rotationDeg != f.rotationDeg || a.lights.size() != b.lights.size()) {
        return false;
    }
    for (size_t i = 0; i < a.lights.size(); ++i) {
        if (!sameLight(a.lights[i], b.lights[i])) { return false; }
    }
    return true;
}

bool sameContent(const SceneDescription& a, const SceneDescription& b) {
    if (a.path != b.path || a.textures.size() != b.textures.size() || a.meshes.size() != b.meshes.size() ||
        a.environmentImages.size() != b.environmentImages.size() || a.objects.size() != b.objects.size()) {
        return false;
    }
    for (size_t i = 0; i < a.meshes.size(); ++i) {
        if (a.meshes[i].data != b.meshes[i].data) { return false; }
    }
    for (size_t i = 0; i < a.objects.size(); ++i) {
        const Object& x = a.objects[i];
        const Object& y = b.objects[i];
        if (x.shape != y.shape || x.mesh != y.mesh || x.material != y.material ||
            x.frontOnly != y.frontOnly) {
            return false;
        }
    }
    return true;
}

bool sameTransforms(const SceneDescription& a, const SceneDescription& b) {
    for (size_t i = 0; i < a.objects.size(); ++i) {
        if (!(a.objects[i].objectToWorld == b.objects[i].objectToWorld)) { return false; }
    }
    return true;
}

/// The integrator chooses between films; the other options are in both of them.
EditKind optionDifferences(const RenderOptions& before, const RenderOptions& after) {
    RenderOptions switched = before;
    switched.integrator = after.integrator;
    EditKind kinds = switched == after ? EditKind::None : EditKind::Options;
    if (before.integrator != after.integrator) { kinds |= EditKind::Integrator; }
    return kinds;
}

}  // namespace

EditKind differences(const SceneDescription& before, const SceneDescription& after) {
    if (!sameContent(before, after)) { return EditKind::Everything; }
    EditKind kinds = materialDifferences(before.materials, after.materials);
    if (!sameCamera(before.camera, after.camera)) { kinds |= EditKind::Camera; }
    if (!(before.resolution == after.resolution)) { kinds |= EditKind::Resolution; }
    kinds |= optionDifferences(before.options, after.options);
    if (!(before.sppm == after.sppm)) { kinds |= EditKind::SppmParameters; }
    if (!sameLights(before, after)) { kinds |= EditKind::Lights; }
    if (!sameTransforms(before, after)) { kinds |= EditKind::ObjectTransform; }
    return kinds;
}

}  // namespace glint
