// Writes a scene as Glint JSON. Whatever the reader knows and affects the picture is written out, so that a
// saved scene does not depend on defaults.
#include <array>
#include <bit>
#include <cstdint>
#include <set>

#include <fmt/format.h>

#include "engine/io/atomic_file.h"
#include "engine/io/embedded_files.h"
#include "engine/io/file_path.h"
#include "engine/io/json_writer.h"
#include "engine/io/scene_json.h"

namespace glint {
namespace {

/// Unlike ==, tells -0 from 0, which a file keeps apart too.
bool sameBits(const Mat3& a, const Mat3& b) {
    using Bits = std::array<uint32_t, 9>;
    return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

/// The items' names, made different from each other and never empty.
template <class Item>
std::vector<std::string> uniqueNames(const std::vector<Item>& items, std::string_view what) {
    std::vector<std::string> names;
    std::set<std::string> taken;
    for (const Item& item : items) {
        const std::string base = item.name.empty() ? std::string(what) : item.name;
        std::string name = base;
        for (int i = 2; !taken.insert(name).second; ++i) {
            name = fmt::format("{} {}", base, i);
        }
        names.push_back(std::move(name));
    }
    return names;
}

class SceneJsonWriter {
  public:
    SceneJsonWriter(const SceneDescription& scene, std::string path)
        : scene_(scene),
          path_(std::move(path)),
          textureNames_(uniqueNames(scene.textures, "texture")),
          materialNames_(uniqueNames(scene.materials, "material")),
          meshNames_(uniqueNames(scene.meshes, "mesh")) {}

    Result<std::string> write() {
        json_.beginObject();
        json_.field("glint", 1);
        json_.field("title", scene_.title);
        json_.field("description", scene_.description);
        const float size[2] = {static_cast<float>(scene_.resolution.width),
                               static_cast<float>(scene_.resolution.height)};
        json_.key("resolution");
        json_.numbers(size, 2);
        writeCamera();
        writeRender();
        section("textures", scene_.textures, textureNames_, &SceneJsonWriter::writeTexture);
        section("materials", scene_.materials, materialNames_, &SceneJsonWriter::writeMaterial);
        section("meshes", scene_.meshes, meshNames_, &SceneJsonWriter::writeMesh);
        writeObjects();
        writeLights();
        writeEnvironment();
        json_.endObject();
        if (!json_.allFinite()) {
            fail("the scene holds a number that is not finite, which cannot be saved");
        }
        return error_ ? Result<std::string>(*error_) : Result<std::string>(json_.text() + "\n");
    }

  private:
    void fail(std::string message) {
        if (!error_) { error_ = Error{std::move(message), {path_, 0, 0, ""}}; }
    }

    std::string rebased(const std::string& path) const { return rebasePath(path, scene_.path, path_); }

    template <class Item>
    void section(std::string_view key, const std::vector<Item>& items, const std::vector<std::string>& names,
                 void (SceneJsonWriter::*writeItem)(const Item&)) {
        json_.key(key);
        json_.beginObject();
        for (size_t i = 0; i < items.size(); ++i) {
            json_.key(names[i]);
            json_.beginObject();
            (this->*writeItem)(items[i]);
            json_.endObject();
        }
        json_.endObject();
    }

    void writeCamera() {
        const Camera& camera = scene_.camera;
        json_.key("camera");
        json_.beginObject();
        json_.field("position", camera.position);
        json_.field("target", camera.target);
        json_.field("up", camera.up);
        json_.field("verticalFovDeg", camera.verticalFovDeg);
        json_.field("horizontalScale", camera.horizontalScale);
        json_.field("apertureDiameter", camera.apertureDiameter);
        json_.field("focalDistance", camera.focalDistance);
        json_.field("apertureBlades", camera.apertureBlades);
        json_.field("bladeRotationDeg", camera.bladeRotationDeg);
        json_.endObject();
    }

    void writeRender() {
        const RenderOptions& options = scene_.options;
        constexpr const char* kFilters[] = {"box", "gaussian", "blackman-harris"};
        json_.key("render");
        json_.beginObject();
        json_.field("integrator", options.integrator == IntegratorKind::Sppm ? "sppm" : "path");
        json_.field("maxDepth", options.maxDepth);
        json_.field("rouletteStartDepth", options.rouletteStartDepth);
        json_.field("filter", kFilters[static_cast<int>(options.filter)]);
        json_.field("filterRadiusPixels", options.filterRadius);
        json_.field("sampler", options.sampler == SamplerKind::Sobol ? "sobol" : "independent");
        json_.field("seed", static_cast<int64_t>(options.seed));
        json_.field("fireflyClamp", options.fireflyClamp);
        writeSppm(scene_.sppm);
        json_.endObject();
    }

    void writeSppm(const SppmOptions& sppm) {
        json_.key("sppm");
        json_.beginObject();
        json_.field("photonsPerPass", static_cast<int64_t>(sppm.photonsPerPass));
        json_.field("alpha", sppm.alpha);
        json_.field("radius", sppm.radiusWorld);
        json_.field("radiusFootprints", sppm.radiusFootprints);
        json_.field("storeRoughness", sppm.storeRoughness);
        json_.field("directLight", sppm.sampleDirectLight ? "sampled" : "photons");
        json_.field("lookup", sppm.lookup == PhotonLookupKind::Grid ? "grid" : "tree");
        json_.field("memoryBudgetMiB", static_cast<int64_t>(sppm.memoryBudgetMiB));
        json_.endObject();
    }

    void writeTexture(const Texture& texture) {
        const std::string path = pathOf(texture.image.source);
        if (path.empty()) {
            fail(fmt::format("the texture \"{}\" is not from a file, so it cannot be saved", texture.name));
        }
        json_.field("file", rebased(path));
        json_.field("encoding", texture.encoding == ColorEncoding::Srgb ? "srgb" : "linear");
        json_.field("flipV", texture.flipV);
        json_.field("scale", texture.scale);
    }

    template <class Input>
    void writeInput(std::string_view key, const Input& input) {
        if (input.texture < 0) {
            json_.field(key, input.value);
            return;
        }
        json_.key(key);
        json_.beginObject();
        json_.field("texture", textureNames_[static_cast<size_t>(input.texture)]);
        json_.field("fallback", input.value);
        json_.endObject();
    }

    void writeMaterial(const Material& material) {
        constexpr const char* kTypes[] = {"diffuse",    "mirror",  "conductor",
                                          "dielectric", "plastic", "mixture"};
        const MaterialKind kind = material.kind;
        json_.field("type", kTypes[static_cast<int>(kind)]);
        writeInput("color", material.color);
        if (kind == MaterialKind::Conductor) {
            if (material.metal.empty()) {
                writeInput("eta", material.eta);
                writeInput("k", material.k);
            } else {
                json_.field("metal", material.metal);
            }
        }
        const bool isMixture = kind == MaterialKind::Mixture;
        if (isMixture || kind == MaterialKind::Dielectric || kind == MaterialKind::Plastic) {
            writeInput("ior", material.ior);
        }
        if (kind == MaterialKind::Conductor || kind == MaterialKind::Dielectric ||
            kind == MaterialKind::Plastic) {
            writeInput("roughness", material.roughness);
        }
        if (kind == MaterialKind::Dielectric) { json_.field("thin", material.thin); }
        if (isMixture) { writeInput("weights", material.mixtureWeights); }
        writeInput("emission", material.emission);
        json_.field("emissionStrength", material.emissionStrength);
        json_.field("emitsBothSides", material.emitsBothSides);
    }

    void writeMesh(const Mesh& mesh) {
        if (const auto* file = std::get_if<FileSource>(&mesh.source)) {
            json_.field("file", rebased(file->path));
            if (file->part >= 0) { json_.field("part", file->part); }
        } else if (const auto* generator = std::get_if<MeshGenerator>(&mesh.source)) {
            json_.field("generator", generator->name);
            json_.field("triangleCount", static_cast<int64_t>(generator->triangles));
            json_.field("seed", static_cast<int64_t>(generator->seed));
        } else if (!mesh.data) {
            fail(fmt::format("the mesh \"{}\" is not from a file, so it cannot be saved", mesh.name));
        } else {
            writeInlineMesh(*mesh.data);
        }
    }

    template <class Vector>
    void writeVectors(std::string_view key, const std::vector<Vector>& vectors) {
        if (vectors.empty()) { return; }
        json_.key(key);
        json_.beginArray();
        for (const Vector& v : vectors) {
            json_.value(v);
        }
        json_.endArray();
    }

    void writeInlineMesh(const MeshData& mesh) {
        writeVectors("positions", mesh.positions);
        writeVectors("normals", mesh.normals);
        writeVectors("uvs", mesh.uvs);
        writeVectors("colors", mesh.colors);
        json_.key("triangles");
        json_.beginArray();
        for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            json_.indices(&mesh.indices[i], 3);
        }
        json_.endArray();
    }

    void writeObjects() {
        json_.key("objects");
        json_.beginArray();
        for (const Object& object : scene_.objects) {
            json_.beginObject();
            writeObject(object);
            json_.endObject();
        }
        json_.endArray();
    }

    void writeObject(const Object& object) {
        constexpr const char* kTypes[] = {"sphere", "plane", "rectangle", "disc", "mesh"};
        json_.field("type", kTypes[static_cast<int>(object.shape)]);
        json_.field("name", object.name);
        json_.field("material", materialNames_[static_cast<size_t>(object.material)]);
        json_.field("frontOnly", object.frontOnly);
        if (object.shape == ShapeKind::Mesh) {
            json_.field("mesh", meshNames_[static_cast<size_t>(object.mesh)]);
        }
        const Mat3& m = object.objectToWorld.linear;
        const Vec3& t = object.objectToWorld.translation;
        if (object.shape == ShapeKind::Sphere && m[0].x > 0.0f && sameBits(m, Mat3(m[0].x))) {
            json_.field("center", t);
            json_.field("radius", m[0].x);
        } else if (!sameBits(m, Mat3(1.0f)) || !isZero(t)) {
            const float rows[12] = {m[0].x, m[1].x, m[2].x, t.x,    m[0].y, m[1].y,
                                    m[2].y, t.y,    m[0].z, m[1].z, m[2].z, t.z};
            json_.key("transform");
            json_.beginObject();
            json_.key("matrix");
            json_.numbers(rows, 12);
            json_.endObject();
        }
    }

    void writeLights() {
        constexpr const char* kTypes[] = {"point", "spot", "directional"};
        json_.key("lights");
        json_.beginArray();
        for (const Light& light : scene_.lights) {
            json_.beginObject();
            json_.field("type", kTypes[static_cast<int>(light.kind)]);
            json_.field("name", light.name);
            if (light.kind != LightKind::Directional) { json_.field("position", light.position); }
            if (light.kind != LightKind::Point) { json_.field("direction", light.direction); }
            json_.field("color", light.color);
            json_.field(light.kind == LightKind::Directional ? "irradiance" : "intensity", light.strength);
            if (light.kind == LightKind::Spot) {
                json_.field("coneAngleDeg", light.coneAngleDeg);
                json_.field("coneFalloffStartDeg", light.coneFalloffStartDeg);
            }
            json_.endObject();
        }
        json_.endArray();
    }

    void writeEnvironment() {
        const Environment& environment = scene_.environment;
        json_.key("environment");
        json_.beginObject();
        json_.field("color", environment.color);
        json_.field("strength", environment.strength);
        json_.field("rotationDeg", environment.rotationDeg);
        if (environment.image >= 0) {
            const SceneImage& image = scene_.environmentImages[static_cast<size_t>(environment.image)];
            json_.key("image");
            json_.beginObject();
            if (const auto* sky = std::get_if<SkySource>(&image.source)) {
                writeSky(*sky);
            } else if (const std::string path = pathOf(image.source); !path.empty()) {
                json_.field("file", rebased(path));
            } else {
                fail("the environment's image is not from a file, so it cannot be saved");
            }
            json_.endObject();
        }
        json_.endObject();
    }

    void writeSky(const SkySource& sky) {
        json_.field("generator", "sky");
        json_.field("zenith", sky.zenith);
        json_.field("horizon", sky.horizon);
        json_.field("ground", sky.ground);
        json_.field("sun", sky.sun);
        json_.field("sunElevationDeg", sky.sunElevationDeg);
        json_.field("sunAzimuthDeg", sky.sunAzimuthDeg);
        json_.field("sunRadiusDeg", sky.sunRadiusDeg);
        json_.field("width", sky.width);
    }

    const SceneDescription& scene_;
    std::string path_;
    std::vector<std::string> textureNames_;
    std::vector<std::string> materialNames_;
    std::vector<std::string> meshNames_;
    JsonWriter json_;
    std::optional<Error> error_;
};

}  // namespace

Result<std::string> writeSceneJson(const SceneDescription& scene, const std::string& path) {
    return SceneJsonWriter(scene, path).write();
}

Status saveSceneJson(const SceneDescription& scene, const std::string& path) {
    SceneDescription named = scene;
    if (Status written = writeEmbeddedFiles(&named, path); !written) { return written; }
    const auto text = writeSceneJson(named, path);
    return text ? writeFileAtomically(path, *text) : Status(text.error());
}

}  // namespace glint
