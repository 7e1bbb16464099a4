// glTF 2.0, text or binary, for viewers and programs that model. What import_gltf.cpp reads as the same
// again; engine/io/README.md says what is approximated.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <tuple>

#include "engine/io/atomic_file.h"
#include "engine/io/exporter.h"
#include "engine/io/file_path.h"
#include "engine/io/gltf_export.h"
#include "engine/io/gltf_nodes.h"
#include "engine/io/projected_image.h"
#include "engine/io/scene_export.h"
#include "engine/io/studio.h"
#include "engine/scene/kind_names.h"

namespace glint {
namespace {

GltfJson matrixOf(const Affine& m) {
    GltfJson numbers = GltfJson::array();
    for (int column = 0; column < 4; ++column) {
        const Vec3 v = column < 3 ? m.linear[column] : m.translation;
        for (int row = 0; row < 3; ++row) {
            numbers.push_back(gltfJson(v[row]));
        }
        numbers.push_back(column < 3 ? 0 : 1);
    }
    return numbers;
}

class GltfExporter : public SceneExport {
  public:
    GltfExporter(SceneDescription scene, const std::string& path, std::vector<std::string>* warnings)
        : SceneExport(std::move(scene), path, warnings), images_(scene_, path_, &out_, &warnings_) {}

    Status run() {
        const bool hadStudio = hasStudio(scene_);
        if (hadStudio) { removeStudio(&scene_); }
        if (scene_.environment.emissive() && !hadStudio) {
            warn("approximated: there is no light from all around");
        }
        isEmitterLit_ = !hadStudio;
        if (makeBumpsNormals(&scene_)) { warn("approximated: bump maps are normal maps"); }
        warnOfSettings();
        writeCamera();
        for (const Light& light : scene_.lights) {
            writeLight(light);
        }
        for (const Object& object : scene_.objects) {
            if (status_) { writeObject(object); }
        }
        if (status_) { status_ = images_.status(); }
        return status_ ? writeFile() : status_;
    }

  private:
    Status writeFile() {
        constexpr size_t kMostBytes = UINT32_MAX - (size_t{1} << 28);
        const bool isBinary = hasExtension(path_, ".glb");
        if (isBinary && out_.buffer().size() > kMostBytes) {
            return Error{"a .glb file ends at 4 GiB; expected a name that ends in .gltf", {.file = path_}};
        }
        if (isBinary) { return writeFileAtomically(path_, out_.binary()); }
        std::string uri;
        if (!out_.buffer().empty()) {
            uri = save(".bin", std::make_shared<const std::string>(out_.buffer()));
        }
        return status_ ? writeFileAtomically(path_, out_.text(gltfUri(uri))) : status_;
    }

    void warnOfSettings() {
        if (!(scene_.options == RenderOptions())) {
            warn("approximated: integrator, depth and filter are the program's own");
        }
        if (std::ranges::any_of(scene_.objects, &Object::frontOnly)) {
            warn("approximated: what is seen from its front alone is seen from behind");
        }
    }

    void writeCamera() {
        const Camera& from = scene_.camera;
        const double aspect = static_cast<double>(scene_.resolution.width) / scene_.resolution.height;
        const CameraAxes axes = axesOf(from);
        Vec3 position = from.position;
        GltfJson camera;
        constexpr double kNear = 1e-3, kFar = 1e6;
        if (from.kind == ProjectionKind::Orthographic) {
            const Vec2 aside = from.viewHeight * from.shift * Vec2(from.horizontalScale, 1.0f);
            position += axes.right * aside.x + axes.up * aside.y;
            const double half = 0.5 * static_cast<double>(from.viewHeight);
            camera = {{"type", "orthographic"},
                      {"orthographic",
                       {{"xmag", half * aspect}, {"ymag", half}, {"znear", kNear}, {"zfar", kFar}}}};
        } else {
            camera = {{"type", "perspective"},
                      {"perspective",
                       {{"yfov", static_cast<double>(from.verticalFovDeg) * (std::numbers::pi / 180.0)},
                        {"aspectRatio", aspect},
                        {"znear", kNear}}}};
            if (from.shift != Vec2(0.0f)) { warn("approximated: the lens is not shifted"); }
        }
        if (from.apertureDiameter > 0.0f) { warn("approximated: all is in focus"); }
        if (from.horizontalScale != 1.0f) { warn("approximated: pixels are square"); }
        out_.addNode({{"name", "camera"},
                      {"camera", out_.add("cameras", std::move(camera))},
                      {"matrix", matrixOf({Mat3(axes.right, axes.up, -axes.forward), position})}});
    }

    /// Colours end at 1.
    void writeLight(const Light& from) {
        if (hasImage(from.kind)) {
            warn(lostImage(from.kind));
            writeLight(withoutImage(scene_, from));
            return;
        }
        const float most = std::max(maxComponent(from.color), 1.0f);
        const double strength = static_cast<double>(from.strength) * static_cast<double>(most);
        GltfJson light{{"name", from.name},
                       {"type", nameOf(from.kind)},  // the same words as in scene files
                       {"color", gltfJson(from.color / most)},
                       {"intensity", strength * kLumensPerWatt}};
        if (from.kind == LightKind::Spot) {
            const double outer = static_cast<double>(from.coneAngleDeg) * (std::numbers::pi / 180.0);
            const double inner = static_cast<double>(from.coneFalloffStartDeg) * (std::numbers::pi / 180.0);
            light["spot"] = {{"innerConeAngle", std::min(inner, std::nextafter(outer, 0.0))},
                             {"outerConeAngle", outer}};
            if (inner < outer) { warn("approximated: spots fall off by the square of the cosine"); }
        }
        GltfJson node = out_.addLight(std::move(light));
        const bool hasDirection = from.kind != LightKind::Point;
        const bool hasPlace = from.kind != LightKind::Directional;
        node["matrix"] = matrixOf(lookingAlong(hasPlace ? from.position : Vec3(0.0f),
                                               hasDirection ? from.direction : Vec3(0, 0, -1)));
        out_.addNode(std::move(node));
    }

    void writeObject(const Object& object) {
        const bool isPlaced = isPlacement(object.objectToWorld);
        const std::optional<size_t> mesh = writtenMesh(object, isPlaced);
        if (!mesh) { return; }
        GltfJson node = GltfJson::object();
        if (!object.name.empty()) { node["name"] = object.name; }
        node["mesh"] = *mesh;
        if (isPlaced && !(object.objectToWorld == Affine())) {
            node["matrix"] = matrixOf(object.objectToWorld);
        }
        out_.addNode(std::move(node));
    }

    /// What the object shows, with its material. Nothing: it has no triangles.
    std::optional<size_t> writtenMesh(const Object& object, bool isPlaced) {
        const auto [known, isNew] = meshes_.try_emplace({shapeOf(object, isPlaced), object.material});
        if (!isNew) { return known->second; }
        const bool isFlipped = flipsV(scene_, object.material);
        const bool isFromTop = tangentsCountFromTop(scene_, object.material);
        GltfJson& primitive = primitives_[{known->first.first, isFlipped, isFromTop}];
        if (primitive.empty()) {
            MeshData mesh = trianglesOf(object);
            if (mesh.indices.empty()) { return std::nullopt; }
            if (!isPlaced) { mesh = placed(std::move(mesh), object.objectToWorld); }
            mesh = withUnitNormals(std::move(mesh));
            if (!makeGltfTangents(&mesh, isFromTop)) {
                warn("approximated: tangents run as the texture coordinates do where a mesh lacks some");
            }
            primitive = out_.addPrimitive(mesh, isFlipped);
        }
        GltfJson part = primitive;
        part["material"] = writtenMaterial(object.material);
        GltfJson mesh = GltfJson::object();
        if (object.shape == ShapeKind::Mesh) {
            mesh["name"] = scene_.meshes[static_cast<size_t>(object.mesh)].name;
        }
        mesh["primitives"] = GltfJson::array({std::move(part)});
        return known->second = out_.add("meshes", std::move(mesh));
    }

    /// The same for objects that share their triangles: shapes by their kind, meshes by their number.
    int shapeOf(const Object& object, bool isPlaced) const {
        constexpr int kOwn = -100;
        if (!isPlaced || object.shape == ShapeKind::Revolved) {
            return kOwn - static_cast<int>(&object - scene_.objects.data());
        }
        return object.shape == ShapeKind::Mesh ? object.mesh : -1 - static_cast<int>(object.shape);
    }

    MeshData trianglesOf(const Object& object) {
        if (object.shape == ShapeKind::Mesh) {
            const MeshData* mesh = meshOf(object);
            return mesh != nullptr ? *mesh : MeshData();
        }
        if (object.shape == ShapeKind::Plane) { warn("approximated: endless planes end"); }
        if (object.shape != ShapeKind::Plane && object.shape != ShapeKind::Rectangle) {
            warn("approximated: round shapes are triangles");
        }
        return shapeMesh(object);
    }

    size_t writtenMaterial(int index) {
        const auto [known, isNew] = materials_.try_emplace(index, 0);
        if (isNew) {
            known->second = writeGltfMaterial(scene_, index, isEmitterLit_, &images_, &out_, &warnings_);
        }
        return known->second;
    }

    GltfWriter out_;
    GltfImages images_;
    bool isEmitterLit_ = true;
    /// By shape, whether v is turned over, and tangents' sides.
    std::map<std::tuple<int, bool, bool>, GltfJson> primitives_;
    std::map<std::pair<int, int>, std::optional<size_t>> meshes_;  ///< by shape and material
    std::map<int, size_t> materials_;
};

Status save(const SceneDescription& scene, const std::string& path, std::vector<std::string>* warnings) {
    return GltfExporter(scene, path, warnings).run();
}

bool isOwn(std::string_view head) { return head.find(R"("generator":"Glint")") != std::string_view::npos; }

}  // namespace

extern const Exporter kExportGltf;
const Exporter kExportGltf{"glTF", ".gltf .glb", save, isOwn};

}  // namespace glint
