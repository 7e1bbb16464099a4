// Counts what the description and the built scene say of themselves.
#include "viewer/commands/scene_report.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <numeric>

#include <fmt/format.h>

#include "engine/builders/light_table.h"
#include "engine/io/image_io.h"
#include "engine/io/used_assets.h"
#include "engine/kernels/shapes/shape_facts.h"
#include "engine/render/cpu_variants.h"
#include "engine/render/sppm_kernel.h"
#include "engine/render/sppm_state.h"
#include "engine/scene/kind_names.h"
#include "engine/scene/scene_use.h"

namespace glint {
namespace {

struct FeatureName {
    FeatureMask bit;
    const char* name;
};
constexpr std::array<FeatureName, 39> kFeatureNames{
    {{kFeatureCurved, "spheres"},
     {kFeaturePlane, "planes"},
     {kFeatureFlat, "rectangles and discs"},
     {kFeatureMesh, "meshes"},
     {kFeatureMeshNormals, "shading normals"},
     {kFeatureMeshColors, "vertex colours"},
     {kFeatureTransforms, "mesh transforms"},
     {kFeatureFrontOnly, "one-sided objects"},
     {kFeatureTextures, "textures"},
     {kFeatureInputTextures, "textures on other inputs than the colour"},
     {kFeaturePlacedTextures, "placed textures"},
     {kFeatureMipmaps, "mip maps"},
     {kFeatureBumps, "bump and normal maps"},
     {kFeatureCutouts, "cut-outs"},
     {kFeatureDiffuse, "diffuse"},
     {kFeatureSpecular, "mirrors and smooth metals"},
     {kFeatureDielectric, "dielectrics"},
     {kFeatureDispersion, "dispersion"},
     {kFeatureGlossy, "rough reflection"},
     {kFeaturePlastic, "plastic"},
     {kFeatureMixture, "mixtures"},
     {kFeatureAttenuation, "absorbing glass"},
     {kFeatureTranslucent, "translucent sheets"},
     {kFeaturePrincipled, "principled materials"},
     {kFeatureCoated, "metals under coats"},
     {kFeatureTransmission, "principled materials that light passes"},
     {kFeatureHighlights, "Phong's and Ward's models"},
     {kFeatureFacets, "facets other than GGX with one alpha"},
     {kFeatureAreaLights, "area lights"},
     {kFeatureDeltaLights, "point, spot and directional lights"},
     {kFeatureProjectors, "projectors and goniometric lights"},
     {kFeatureEnvironmentConstant, "constant environment"},
     {kFeatureEnvironmentImage, "environment image"},
     {kFeaturePortal, "portals"},
     {kFeatureManyLights, "light tree"},
     {kFeatureCameraArea, "depth of field or parallel rays"},
     {kFeatureRevolved, "surfaces of revolution"},
     {kFeatureAccelerators, "kd-trees, boxes, no acceleration structure"},
     {kFeatureIndependentSampler, "independent sampler"}}};
static_assert(std::accumulate(kFeatureNames.begin(), kFeatureNames.end(), FeatureMask{0},
                              [](FeatureMask all, const FeatureName& f) { return all | f.bit; }) ==
              kAllFeatures);

/// Of the kinds that occur.
template <class Items, class Kind>
std::vector<NamedCount> countByKind(const Items& items, Kind Items::value_type::*kindOf) {
    std::vector<NamedCount> out;
    for (const KindName<Kind>& entry : kindNames<Kind>()) {
        const auto count = std::ranges::count(items, entry.kind, kindOf);
        if (count > 0) { out.push_back({std::string(entry.name), static_cast<uint64_t>(count)}); }
    }
    return out;
}

/// Materials that gather light into caustics.
constexpr FeatureMask kCasters = kFeatureSpecular | kFeatureDielectric | kFeatureGlossy | kFeaturePlastic |
                                 kFeatureMixture | kFeaturePrincipled | kFeatureHighlights | kFeatureCoated;

void countLights(const SceneDescription& scene, const BuiltScene& built, SceneReport* report) {
    report->lights = countByKind(scene.lights, &Light::kind);
    const auto emissive = std::ranges::count_if(scene.objects, [&](const Object& object) {
        return scene.materials[static_cast<size_t>(object.material)].emissive();
    });
    if (emissive > 0) { report->lights.push_back({"emissive object", static_cast<uint64_t>(emissive)}); }
    if (scene.environment.emissive()) {
        report->lights.push_back(
            {scene.environment.image >= 0 ? "environment image" : "constant environment", 1});
    }
    report->lights.push_back({"emitter in the light table", built.lights->emitters.size()});
}

void listWhatIsLeftOut(FeatureMask compiled, const SceneDescription& scene, const BuiltScene& built,
                       SceneReport* report) {
    for (const std::string& name : featureNames(kAllFeatures & ~compiled)) {
        report->leftOut.push_back("kernel: " + name);
    }
    const auto countUnused = [](const std::vector<bool>& used) {
        return static_cast<size_t>(std::ranges::count(used, false));
    };
    const std::pair<const char*, size_t> unused[] = {
        {"meshes that no object places", countUnused(usedMeshes(scene))},
        {"materials that no object has", countUnused(usedMaterials(scene))},
        {"textures that no object uses", countUnused(usedTextures(scene))}};
    for (const auto& [what, count] : unused) {
        if (count > 0) { report->leftOut.push_back(fmt::format("{}: {}", what, count)); }
    }
    const auto withoutUvs = std::ranges::count_if(
        scene.meshes, [](const Mesh& mesh) { return mesh.data && mesh.data->uvsLeftOut; });
    if (withoutUvs > 0) {
        report->leftOut.push_back(
            fmt::format("texture coordinates of meshes that need none: {}", withoutUvs));
    }
    if (!built.lights->usesTree && !built.lights->emitters.empty()) {
        report->leftOut.emplace_back("light tree: the few lights are weighed one by one");
    }
    report->leftOut.emplace_back("AOV buffers, until one is asked for");
    if (scene.options.integrator == IntegratorKind::PathTracing) {
        report->leftOut.emplace_back("photons and their statistics, until photon mapping is asked for");
    }
}

std::vector<NotRead> listWhatIsNotRead(const SceneDescription& scene) {
    std::vector<NotRead> out;
    for (const Asset& asset : idleAssets(scene)) {
        NotRead item;
        item.file = assetFile(scene, asset);
        const std::string resolved = resolvePath(item.file, scene.path);
        std::error_code problem;
        const auto size = std::filesystem::file_size(resolved, problem);
        if (!item.file.empty() && !problem) { item.fileBytes = size; }
        if (asset.kind == AssetKind::Mesh) {
            item.kind = "mesh";
            item.name = scene.meshes[asset.index].name;
            item.why = "no object places it";
        } else {
            const bool isTexture = asset.kind == AssetKind::Texture;
            item.kind = isTexture ? "texture" : "environment image";
            item.name = isTexture ? scene.textures[asset.index].name : item.file;
            item.why = isTexture ? "no object uses it" : "the environment does not shine with it";
            item.memoryBytes = statedPixelBytes(resolved);
            const SkySource* sky =
                isTexture ? nullptr : std::get_if<SkySource>(&scene.environmentImages[asset.index].source);
            if (sky != nullptr) {
                const auto width = static_cast<uint64_t>(sky->width);
                item.name = "sky";
                item.memoryBytes = width * (width / 2) * 3 * sizeof(float);
            }
        }
        if (!item.file.empty() && !item.fileBytes) { item.why = "the file is missing"; }
        out.push_back(std::move(item));
    }
    return out;
}

}  // namespace

std::vector<std::string> featureNames(FeatureMask mask) {
    std::vector<std::string> names;
    for (const FeatureName& feature : kFeatureNames) {
        if ((mask & feature.bit) != 0) { names.emplace_back(feature.name); }
    }
    return names;
}

SceneReport reportOf(const SceneDescription& scene, const BuiltScene& built) {
    SceneReport report;
    report.objects = countByKind(scene.objects, &Object::shape);
    report.hiddenObjects = countByKind(scene.hiddenObjects, &Object::shape);
    report.materials = countByKind(scene.materials, &Material::kind);
    report.meshes = scene.meshes.size();
    for (const Mesh& mesh : scene.meshes) {
        report.triangles += mesh.data ? mesh.data->triangleCount() : 0;
    }
    for (const Object& object : scene.objects) {
        if (object.shape == ShapeKind::Mesh) {
            report.placedTriangles += scene.meshes[static_cast<size_t>(object.mesh)].data->triangleCount();
        }
    }
    report.textures = scene.textures.size();
    countLights(scene, built, &report);
    const SamplerKind sampler = scene.options.sampler;
    report.features = featureNames(neededFeatures(built.features, sampler));
    const KernelVariant& variant = chooseVariant(kernelVariants(), built.features, sampler);
    report.kernel = variant.name;
    report.sppmKernel = chooseVariant(sppmVariants(), built.features, sampler).name;
    report.sppm = planSppmMemory(scene);
    report.hasCausticCaster = (built.features & kCasters) != 0;
    report.hasGlowingPlane =
        std::any_of(scene.objects.begin(), scene.objects.end(), [&](const Object& object) {
            return !isSampledAsLight(object.shape) && object.material >= 0 &&
                   scene.materials[static_cast<size_t>(object.material)].emissive();
        });
    listWhatIsLeftOut(variant.mask, scene, built, &report);
    report.placedMeshes = static_cast<uint64_t>(std::ranges::count(usedMeshes(scene), true));
    report.usedTextures = static_cast<uint64_t>(std::ranges::count(usedTextures(scene), true));
    report.notRead = listWhatIsNotRead(scene);
    LeftOnDisk left;
    for (const NotRead& item : report.notRead) {
        (item.kind == "texture" ? left.textures : left.environment) += item.memoryBytes.value_or(0);
    }
    report.memory = memoryTableOf(scene, built, left);
    return report;
}

}  // namespace glint
