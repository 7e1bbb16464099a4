#include "engine/builders/feature_scan.h"

#include "engine/builders/material_table.h"
#include "engine/kernels/bsdf/bsdf.h"
#include "engine/kernels/shapes/shape_facts.h"
#include "engine/scene/scene_use.h"

namespace glint {
namespace {

FeatureMask objectFeatures(const SceneDescription& scene, const Object& object) {
    FeatureMask mask = object.frontOnly ? kFeatureFrontOnly : FeatureMask{0};
    mask |= featureOf(object.shape);
    if (object.shape != ShapeKind::Mesh) { return mask; }
    mask |= object.objectToWorld == Affine{} ? FeatureMask{0} : kFeatureTransforms;
    if (object.mesh >= 0 && static_cast<size_t>(object.mesh) < scene.meshes.size()) {
        const auto& data = scene.meshes[static_cast<size_t>(object.mesh)].data;
        mask |= data && !data->normals.empty() ? kFeatureMeshNormals : FeatureMask{0};
        mask |= data && !data->colors.empty() ? kFeatureMeshColors : FeatureMask{0};
    }
    return mask;
}

}  // namespace

FeatureMask scanFeatures(const SceneDescription& scene, const MaterialTable& materials) {
    const bool hasArea =
        scene.camera.apertureDiameter > 0.0f || scene.camera.kind == ProjectionKind::Orthographic;
    FeatureMask mask = hasArea ? kFeatureCameraArea : FeatureMask{0};
    for (const Object& object : scene.objects) {
        mask |= objectFeatures(scene, object);
    }
    const std::vector<bool> used = usedMaterials(scene);
    for (size_t i = 0; i < used.size(); ++i) {
        mask |= used[i] ? materialFeatures(materials.materials[i]) : 0u;
    }
    const std::vector<bool> shown = usedTextures(scene);
    for (size_t i = 0; i < shown.size(); ++i) {
        mask |= shown[i] && scene.textures[i].isPlaced() ? kFeaturePlacedTextures : FeatureMask{0};
    }
    return mask;
}

}  // namespace glint
