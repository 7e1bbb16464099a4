// glTF 2.0: the scene's nodes with their meshes, cameras and lights. engine/io/README.md says what maps
// to what.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <fmt/format.h>

#include "engine/io/asset_cache.h"
#include "engine/io/default_view.h"
#include "engine/io/file_kind.h"
#include "engine/io/gltf_animation.h"
#include "engine/io/gltf_meshes.h"
#include "engine/io/gltf_nodes.h"
#include "engine/io/gltf_parameters.h"
#include "engine/io/importer.h"
#include "engine/io/used_assets.h"

namespace glint {
namespace {

/// Nodes that share a mesh of many primitives cost a file next to nothing, but 440 bytes an object: so many
/// are placed whatever the file's size, one for each of its bytes beyond that, and never more than the most.
constexpr uint64_t kFreeObjects = 100'000, kMaxObjects = 4'000'000;

/// What kind of picture the camera makes, and its width over its height; 0: unknown. False: it makes
/// no sense.
bool setLens(const tinygltf::Camera& from, Camera* camera, double* aspect) {
    if (from.type == "orthographic") {
        const double width = from.orthographic.xmag, height = from.orthographic.ymag;
        camera->kind = ProjectionKind::Orthographic;
        camera->viewHeight = static_cast<float>(2.0 * height);
        *aspect = width / height;
        return width > 0.0 && height > 0.0 && std::isfinite(camera->viewHeight) && std::isfinite(*aspect);
    }
    camera->verticalFovDeg = static_cast<float>(from.perspective.yfov * (180.0 / std::numbers::pi));
    *aspect = from.perspective.aspectRatio;
    return from.type == "perspective" && camera->verticalFovDeg > 0.0f && camera->verticalFovDeg < 180.0f;
}

/// What is placed by greater numbers has no finite bounds.
bool isWithinReach(const Affine& toWorld) {
    constexpr float kMost = 1e18f;
    const auto isSane = [](const Vec3& v) { return maxComponent(absVec(v)) <= kMost; };
    const Mat3& m = toWorld.linear;
    return isSane(m[0]) && isSane(m[1]) && isSane(m[2]) && isSane(toWorld.translation);
}

class GltfReader {
  public:
    GltfReader(GltfFile* file, bool noStudio)
        : file_(*file), noStudio_(noStudio), materials_(file, &scene_), meshes_(file, &materials_, &scene_) {
        scene_.path = file->path;
        scene_.title = file->path.substr(file->path.find_last_of('/') + 1);
    }

    Result<SceneDescription> read(LoadCounts* counts) {
        if (Status nodes = readNodes(); !nodes) { return nodes.error(); }
        if (scene_.objects.empty()) {
            return file_.error("the file has no triangles in its scene; expected a mesh");
        }
        AssetCache assets(file_.path, counts);
        readUsedAssets(&assets, &scene_, [&](const Asset& asset, const Error& error) {
            remarkUnreadImage(asset, error, &scene_, &file_.remarks);
            return true;
        });
        applyDefaultView(&scene_, noStudio_);
        if (hasNoEmitter()) { lightModel(&scene_, noStudio_); }
        if (camera_) { useCamera(*camera_); }
        for (const Asset& asset : lackingAssets(scene_)) {  // the studio's light
            if (Status read = readAsset(asset, &assets, &scene_); !read) { return read.error(); }
        }
        const std::vector<std::string> lines = file_.remarks.lines();
        scene_.warnings.insert(scene_.warnings.end(), lines.begin(), lines.end());
        return std::move(scene_);
    }

  private:
    struct Placed {
        int node;
        Affine toWorld;
    };
    struct PlacedCamera {
        int camera;
        Affine toWorld;
    };

    Status readNodes() {
        std::vector<int> order;
        if (Status placed = placeNodes(&order); !placed) { return placed; }
        for (const int node : order) {
            if (Status read = readNode(node); !read) { return read; }
        }
        return {};
    }

    /// Each node has one parent, so that none is met twice.
    Status placeNodes(std::vector<int>* order) {
        std::vector<bool> met(file_.model.nodes.size(), false);
        toWorld_.assign(met.size(), {});
        std::vector<Placed> waiting;
        const std::vector<int> roots = rootsOf(file_.model);
        for (size_t i = roots.size(); i-- > 0;) {
            waiting.push_back({roots[i], {}});
        }
        while (!waiting.empty()) {
            const Placed next = waiting.back();
            waiting.pop_back();
            const auto index = static_cast<size_t>(next.node);
            if (next.node < 0 || index >= met.size()) {
                return file_.error(
                    fmt::format("there is no node {}; the file has {}", next.node, met.size()));
            }
            if (met[index]) {
                return file_.error(fmt::format("node {} has two parents, or is its own", next.node));
            }
            met[index] = true;
            const tinygltf::Node& node = file_.model.nodes[index];
            const Affine toWorld = toWorld_[index] = next.toWorld * placementOf(node);
            order->push_back(next.node);
            for (size_t i = node.children.size(); i-- > 0;) {
                waiting.push_back({node.children[i], toWorld});
            }
        }
        return {};
    }

    Status readNode(int index) {
        const tinygltf::Node& node = file_.model.nodes[static_cast<size_t>(index)];
        const Affine toWorld = toWorld_[static_cast<size_t>(index)];
        if (node.mesh >= 0) {
            const auto instances = instancesOf(file_, node);
            if (!instances) { return instances.error(); }
            for (const Affine& instance : *instances) {
                if (Status placed = placeMesh(node, toWorld * instance); !placed) { return placed; }
            }
        }
        if (node.camera >= 0) {
            if (!camera_) {
                camera_ = PlacedCamera{node.camera, toWorld};
            } else {
                file_.remark("cameras after the first are left out", node.name);
            }
        }
        const double light = numberOf(extensionOf(node, "KHR_lights_punctual"), "light", -1.0);
        return light >= 0.0 ? addLight(static_cast<int>(std::min(light, 1e9)), toWorld) : Status();
    }

    /// A skin's joints alone place its mesh.
    Status placeMesh(const tinygltf::Node& node, const Affine& nodeToWorld) {
        GltfPose pose{.weights = node.weights};
        if (node.skin >= 0) {
            const auto [joints, isNew] = joints_.try_emplace(node.skin);
            if (isNew) {
                auto read = jointsOf(file_, node.skin, toWorld_);
                if (!read) { return read.error(); }
                joints->second = std::move(*read);
            }
            pose.skin = node.skin;
            pose.joints = joints->second;
        }
        const auto parts = meshes_.take(node.mesh, pose);
        if (!parts) { return parts.error(); }
        const Affine toWorld = pose.joints.empty() ? nodeToWorld : Affine();
        if (!isInvertible(toWorld) || !isWithinReach(toWorld)) {
            file_.remark("nodes that are flattened or not finite are left out", node.name);
            return {};
        }
        const uint64_t most = std::clamp(file_.bytes, kFreeObjects, kMaxObjects);
        if (scene_.objects.size() + parts->size() > most) {
            return file_.error(fmt::format(
                "its nodes place more than {} meshes, which is too many for {} bytes", most, file_.bytes));
        }
        for (const GltfPart& part : *parts) {
            Object object;
            object.name = node.name.empty() ? scene_.meshes[static_cast<size_t>(part.mesh)].name : node.name;
            object.shape = ShapeKind::Mesh;
            object.mesh = part.mesh;
            object.material = part.material;
            object.objectToWorld = toWorld;
            scene_.objects.push_back(std::move(object));
        }
        return {};
    }

    Status addLight(int index, const Affine& toWorld) {
        const auto& lights = file_.model.lights;
        if (static_cast<size_t>(index) >= lights.size()) {
            return file_.error(fmt::format("there is no light {}; the file has {}", index, lights.size()));
        }
        const tinygltf::Light& from = lights[static_cast<size_t>(index)];
        std::optional<Light> light = lightOf(from, toWorld);
        if (!light) {
            file_.remark("lights without a direction are left out", from.name);
            return {};
        }
        if (light->name.empty()) { light->name = fmt::format("light {}", index); }
        scene_.lights.push_back(std::move(*light));
        return {};
    }

    /// Emission up to 1 is how labels and screens look: viewers light such models.
    bool hasNoEmitter() const {
        return scene_.lights.empty() && !scene_.environment.emissive() &&
               std::ranges::all_of(scene_.materials,
                                   [](const Material& m) { return m.emissionStrength <= 1.0f; });
    }

    void useCamera(const PlacedCamera& placed) {
        const auto& cameras = file_.model.cameras;
        const Vec3 forward = placed.toWorld.vector({0, 0, -1}), position = placed.toWorld.translation;
        Camera camera = scene_.camera;
        double aspect = 0.0;
        if (static_cast<size_t>(placed.camera) >= cameras.size() ||
            !setLens(cameras[static_cast<size_t>(placed.camera)], &camera, &aspect) || isZero(forward) ||
            !isFinite(forward) || !isFinite(position)) {
            file_.remark("the camera makes no sense: the default view takes its place");
            return;
        }
        // The orbit centre is where the model's middle is closest to the line of sight.
        const Vec3 unit = glm::normalize(forward);
        const float distance = glm::dot(camera.target - position, unit);
        camera.focalDistance = distance > 0.0f ? distance : 1.0f;
        camera.target = position + camera.focalDistance * unit;
        camera.position = position;
        camera.up = placed.toWorld.vector({0, 1, 0});
        if (aspect > 0.0) {
            scene_.resolution.width = static_cast<int>(std::clamp(std::round(600.0 * aspect), 60.0, 6000.0));
        }
        scene_.camera = camera;
    }

    GltfFile& file_;
    bool noStudio_;
    SceneDescription scene_;
    GltfMaterials materials_;
    GltfMeshes meshes_;
    std::optional<PlacedCamera> camera_;
    std::vector<Affine> toWorld_;                ///< of each node of the scene
    std::map<int, std::vector<Affine>> joints_;  ///< of skins that were met
};

Result<SceneDescription> load(const std::string& path, const LoadOptions& options) {
    const auto file = readGltfFile(path);
    if (!file) { return file.error(); }
    std::string pose, variant;
    if (Status posed = poseNodes(file->get(), options.parameters, &pose); !posed) { return posed.error(); }
    if (Status chosen = chooseVariant(file->get(), options.parameters, &variant); !chosen) {
        return chosen.error();
    }
    auto scene = GltfReader(file->get(), options.noStudio).read(options.counts);
    for (const auto& [name, value] : options.parameters) {
        const bool isKnown = name == "animation" || name == "variant" ||
                             (name == "time" && !(*file)->model.animations.empty());
        if (scene && !isKnown) {
            scene->warnings.push_back(fmt::format("{}: the scene has no parameter \"{}\"", path, name));
        }
    }
    for (const std::string& note : {pose, variant}) {
        if (scene && !note.empty()) { scene->notes.push_back(note); }
    }
    return scene;
}

}  // namespace

bool looksLikeGltf(std::string_view head) {
    const auto has = [head](std::string_view word) { return head.find(word) != std::string_view::npos; };
    if (head.starts_with("glTF")) { return true; }
    constexpr std::string_view kKeys[] = {"\"asset\"",  "\"accessors\"", "\"bufferViews\"",
                                          "\"scenes\"", "\"nodes\"",     "\"extensionsUsed\""};
    return firstText(head).starts_with('{') && !has("\"glint\"") && std::ranges::any_of(kKeys, has);
}

extern const Importer kImportGltf;
const Importer kImportGltf{.name = "glTF",
                           .extensions = ".gltf .glb",
                           .looksLike = looksLikeGltf,
                           .load = load,
                           .hasParameters = true};

}  // namespace glint
