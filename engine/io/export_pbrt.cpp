// pbrt-v4 scenes, so that a scene can be checked against that program. What import_pbrt.cpp reads as the same
// again; engine/io/README.md says what is approximated.
#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include <fmt/format.h>

#include "engine/io/atomic_file.h"
#include "engine/io/baked_image.h"
#include "engine/io/embedded_files.h"
#include "engine/io/exporter.h"
#include "engine/io/file_path.h"
#include "engine/io/mitsuba_writer.h"
#include "engine/io/pbrt_environment.h"
#include "engine/io/pbrt_writer.h"
#include "engine/io/ply_writer.h"
#include "engine/scene/scene_use.h"

namespace glint {
namespace {

/// Half the side of what stands for an endless plane.
constexpr float kPlaneSize = 1e4f;

/// The file's first line.
constexpr std::string_view kOwnMark = "# Written by Glint.\n";

class PbrtExporter {
  public:
    PbrtExporter(SceneDescription scene, const std::string& path, std::vector<std::string>* warnings)
        : scene_(std::move(scene)), path_(path), warnings_(*warnings) {}

    Status run() {
        if (Status written = writeEmbeddedFiles(&scene_, path_); !written) { return written; }
        for (Texture& texture : scene_.textures) {
            if (auto* file = std::get_if<FileSource>(&texture.image.source)) {
                file->path = rebasePath(file->path, scene_.path, path_);
            }
        }
        out_ = std::string(kOwnMark) + pbrtView(scene_, &warnings_);
        writeEnvironment();
        for (const Light& light : scene_.lights) {
            writeLight(light);
        }
        writeMaterials();
        for (const Object& object : scene_.objects) {
            if (status_) { writeObject(object); }
        }
        return status_ ? writeFileAtomically(path_, out_) : status_;
    }

  private:
    void warn(std::string_view sentence) { warnOnce(sentence, &warnings_); }
    const Material& materialOf(const Object& object) const {
        return scene_.materials[static_cast<size_t>(object.material)];
    }

    void writeEnvironment() {
        const Environment& environment = scene_.environment;
        if (!environment.emissive()) { return; }
        out_ += "LightSource \"infinite\"" + pbrtNumber("scale", environment.strength);
        if (environment.image < 0) {
            out_ += pbrtRgb("L", environment.color) + "\n";
            return;
        }
        warn("approximated: the environment is laid out anew");
        const SceneImage& image = scene_.environmentImages[static_cast<size_t>(environment.image)];
        if (!image.floats) {
            status_ = Error{"the environment has not been read", {.file = path_}};
            return;
        }
        ImageF map = equalAreaOfLatLong(*image.floats, environment.rotationDeg);
        for (size_t i = 0; i < map.rgb.size(); ++i) {
            map.rgb[i] *= environment.color[static_cast<int>(i % 3)];
        }
        const std::string name =
            save("-environment.exr", std::get<EmbeddedFile>(bakedImage(map, path_, 0)).bytes);
        out_ += pbrtString("filename", name) + "\n";
    }

    void writeLight(const Light& light) {
        const std::string power = pbrtRgb(light.kind == LightKind::Directional ? "L" : "I", light.color) +
                                  pbrtNumber("scale", light.strength);
        if (light.kind == LightKind::Point) {
            out_ += "LightSource \"point\"" + pbrtPoint("from", light.position) + power + "\n";
            return;
        }
        const std::string towards = pbrtPoint("to", light.direction) + power;
        if (light.kind == LightKind::Directional) {
            out_ += "LightSource \"distant\"" + towards + "\n";
            return;
        }
        out_ += fmt::format("AttributeBegin\nTranslate {} {} {}\nLightSource \"spot\"{}{}{}\nAttributeEnd\n",
                            light.position.x, light.position.y, light.position.z, towards,
                            pbrtNumber("coneangle", light.coneAngleDeg),
                            pbrtNumber("conedeltaangle", light.coneAngleDeg - light.coneFalloffStartDeg));
    }

    static bool absorbs(const Material& material) {
        return material.kind == MaterialKind::Dielectric && !isZero(absorptionOf(material));
    }
    /// Of a glass that absorbs inside.
    static std::string mediumName(int material) { return fmt::format("\"inside m{}\"", material); }

    /// Textures first, which materials name.
    void writeMaterials() {
        std::set<std::pair<int, bool>> textures;
        const std::vector<bool> used = usedMaterials(scene_);
        for (size_t i = 0; i < used.size(); ++i) {
            if (!used[i]) { continue; }
            const Material& material = scene_.materials[i];
            forEachInput(material, [&](std::string_view, const auto& input) {
                constexpr bool kIsNumber = std::is_same_v<std::decay_t<decltype(input)>, NumberInput>;
                if (input.texture >= 0) { textures.insert({input.texture, kIsNumber}); }
            });
        }
        for (const auto& [index, isNumber] : textures) {
            out_ += pbrtTexture(scene_, index, isNumber, &warnings_);
        }
        for (size_t i = 0; i < used.size(); ++i) {
            if (!used[i]) { continue; }
            out_ += pbrtMaterial(scene_, static_cast<int>(i), &warnings_);
            if (absorbs(scene_.materials[i])) {
                out_ += fmt::format("MakeNamedMedium {}", mediumName(static_cast<int>(i))) +
                        pbrtString("type", "homogeneous") +
                        pbrtRgb("sigma_a", absorptionOf(scene_.materials[i])) +
                        pbrtRgb("sigma_s", Vec3(0.0f)) + "\n";
            }
        }
    }

    /// Says under which name the file was written.
    std::string save(std::string_view ending, std::shared_ptr<const std::string> bytes) {
        std::string wanted = std::filesystem::path(path_).stem().string() + std::string(ending);
        if (!status_) { return wanted; }
        const Result<std::string> name = writeBeside({wanted, std::move(bytes)}, path_);
        if (!name) { status_ = name.error(); }
        return name ? *name : wanted;
    }

    void writeObject(const Object& object) {
        constexpr std::string_view kSquare = "\"bilinearmesh\" \"point3 P\" [-1 -1 0  1 -1 0  -1 1 0  1 1 0]";
        if (object.frontOnly) { warn("approximated: what is seen from its front alone is seen from behind"); }
        switch (object.shape) {
            case ShapeKind::Mesh:
                writeMesh(object);
                return;
            case ShapeKind::Sphere:  // pbrt's north is +z, and its u begins at +x
                writeShape("\"sphere\"", object,
                           object.objectToWorld * Affine{Mat3(0, 0, -1, -1, 0, 0, 0, 1, 0), Vec3(0.0f)});
                return;
            case ShapeKind::Plane:
                warn("approximated: endless planes end");
                writeShape(kSquare, object, object.objectToWorld * scale(Vec3(kPlaneSize, kPlaneSize, 1.0f)));
                return;
            case ShapeKind::Rectangle:
                writeShape(kSquare, object, object.objectToWorld);
                return;
            case ShapeKind::Disc:
                if (!usedTextures(materialOf(object)).empty()) {
                    warn("approximated: textures lie around the middles of disks");
                }
                writeShape("\"disk\"", object, object.objectToWorld);
                return;
            case ShapeKind::Revolved:
                writeRevolved(object);
                return;
        }
    }

    void writeRevolved(const Object& object) {
        const std::vector<Vec2>& p = object.profile;
        if (p.size() == 2 && p[0].x == p[1].x && p[0].y > p[1].y && !object.capped) {
            // pbrt's axis is z, Glint's y.
            writeShape("\"cylinder\"" + pbrtNumber("radius", p[0].x) + pbrtNumber("zmin", p[1].y) +
                           pbrtNumber("zmax", p[0].y),
                       object, object.objectToWorld * Affine{Mat3(1, 0, 0, 0, 0, -1, 0, 1, 0), Vec3(0.0f)});
            return;
        }
        warn("approximated: profiles that are turned are triangles");
        writePly(newPly(turnedMesh(object)), object);
    }

    void writeMesh(const Object& object) {
        const Mesh& mesh = scene_.meshes[static_cast<size_t>(object.mesh)];
        if (!mesh.data) {
            status_ = Error{fmt::format("the mesh \"{}\" has not been read", mesh.name), {.file = path_}};
            return;
        }
        if (!mesh.data->colors.empty()) { warn("approximated: vertices have no colours"); }
        if (!mesh.data->normals.empty() && std::ranges::any_of(mesh.data->normals, isZero)) {
            warn("approximated: meshes are smooth everywhere or nowhere");
        }
        std::string& name = plys_[object.mesh];
        if (name.empty()) { name = newPly(*mesh.data); }
        writePly(name, object);
    }

    std::string newPly(const MeshData& mesh) {
        MeshData shown = mesh;
        shown.colors.clear();
        return save(fmt::format("-{}.ply", plyCount_++),
                    std::make_shared<const std::string>(encodePly(shown)));
    }
    void writePly(const std::string& name, const Object& object) {
        writeShape("\"plymesh\"" + pbrtString("filename", name), object, object.objectToWorld);
    }

    void writeShape(std::string_view shape, const Object& object, const Affine& toWorld) {
        out_ += "AttributeBegin\n";
        if (!(toWorld == Affine())) {
            out_ += "Transform [";
            for (int column = 0; column < 4; ++column) {
                const Vec3 v = column < 3 ? toWorld.linear[column] : toWorld.translation;
                out_ += fmt::format("{} {} {} {} ", v.x, v.y, v.z, column < 3 ? 0 : 1);
            }
            out_ += "]\n";
        }
        const Material& material = materialOf(object);
        if (material.emissive()) {
            out_ += "AreaLightSource \"diffuse\"" + pbrtNumber("scale", material.emissionStrength);
            if (material.emission.texture >= 0) {
                const Texture& image = scene_.textures[static_cast<size_t>(material.emission.texture)];
                out_ += pbrtString("filename", pathOf(image.image.source));
                if (image.isPlaced() || image.flipV || image.scale != Vec2(1.0f)) {
                    warn("approximated: pictures that shine are not placed");
                }
            } else {
                out_ += pbrtRgb("L", material.emission.value);
            }
            if (material.emitsBothSides) { out_ += pbrtFlag("twosided", true); }
            out_ += "\n";
        }
        if (absorbs(material)) {
            out_ += fmt::format("MediumInterface {} \"\"\n", mediumName(object.material));
        }
        out_ += fmt::format("NamedMaterial {}\nShape {}", pbrtMaterialName(scene_, object.material), shape);
        if (material.opacity.texture >= 0 || material.opacity.value < 1.0f) {
            out_ += pbrtNumberInput("alpha", material.opacity);
        }
        out_ += "\nAttributeEnd\n";
    }

    SceneDescription scene_;
    std::string path_;
    std::vector<std::string>& warnings_;
    std::string out_;
    std::map<int, std::string> plys_;
    int plyCount_ = 0;
    Status status_;
};

Status save(const SceneDescription& scene, const std::string& path, std::vector<std::string>* warnings) {
    return PbrtExporter(scene, path, warnings).run();
}

bool isOwn(std::string_view head) { return head.starts_with(kOwnMark); }

}  // namespace

extern const Exporter kExportPbrt;
const Exporter kExportPbrt{"pbrt-v4", ".pbrt", save, isOwn};

}  // namespace glint
