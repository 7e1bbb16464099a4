// pbrt-v4 scenes, so that a scene can be checked against that program. What import_pbrt.cpp reads as the same
// again; engine/io/README.md says what is approximated.
#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "engine/io/atomic_file.h"
#include "engine/io/exporter.h"
#include "engine/io/pbrt_environment.h"
#include "engine/io/pbrt_writer.h"
#include "engine/io/projected_image.h"
#include "engine/io/scene_export.h"
#include "engine/scene/scene_use.h"
#include "engine/scene/shape_forms.h"

namespace glint {
namespace {

/// The file's first line.
constexpr std::string_view kOwnMark = "# Written by Glint.\n";

class PbrtExporter : public SceneExport {
  public:
    PbrtExporter(SceneDescription scene, const std::string& path, std::vector<std::string>* warnings)
        : SceneExport(std::move(scene), path, warnings, true) {}

    Status run() {
        placeTextures();
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
    void writeEnvironment() {
        const Environment& environment = scene_.environment;
        if (!environment.emissive()) { return; }
        out_ += "LightSource \"infinite\"" + pbrtNumber("scale", environment.strength);
        if (!environment.portal.empty()) { out_ += pbrtPoints("portal", environment.portal); }
        if (environment.image < 0 && !environment.portal.empty()) {  // pbrt has portals of images alone
            const ImageF even{16, 16, std::vector<float>(size_t{3} * 16 * 16, 1.0f)};
            out_ += pbrtString("filename", saveEnvironment(even, environment.color)) + "\n";
            return;
        }
        if (environment.image < 0) {
            out_ += pbrtRgb("L", environment.color) + "\n";
            return;
        }
        warn("approximated: the environment is laid out anew");
        const std::shared_ptr<const ImageF> image = environmentImage();
        if (image == nullptr) { return; }
        const std::string name =
            saveEnvironment(equalAreaOfLatLong(*image, environment.rotationDeg), environment.color);
        out_ += pbrtString("filename", name) + "\n";
    }

    void writeLight(const Light& light) {
        if (light.kind == LightKind::Goniometric && light.image.texture < 0) {
            writeLight(withoutImage(scene_, light));
            return;
        }
        if (hasImage(light.kind)) {
            writeWithImage(light);
            return;
        }
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

    /// pbrt projects images without a colour of their own.
    void writeWithImage(const Light& light) {
        const bool projects = light.kind == LightKind::Projector;
        ImageF image =
            projects ? pbrtProjectedImage(scene_, light) : pbrtGoniometricImage(scene_, light, &warnings_);
        for (size_t i = 0; projects && i < image.rgb.size(); ++i) {
            image.rgb[i] *= light.color[static_cast<int>(i % 3)];
        }
        out_ += pbrtImageLight(light, saveImage(fmt::format("-light{}.exr", images_++), image));
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
            forEachInput(material, [&](const FieldTraits&, const auto& input) {
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
            if (absorbsInside(scene_.materials[i])) {
                out_ += fmt::format("MakeNamedMedium {}", mediumName(static_cast<int>(i))) +
                        pbrtString("type", "homogeneous") +
                        pbrtRgb("sigma_a", absorptionOf(scene_.materials[i])) +
                        pbrtRgb("sigma_s", Vec3(0.0f)) + "\n";
            }
        }
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
                if (isTextured(object)) { return writePly(savePly(shapeMesh(object)), object); }
                writeShape(kSquare, object,
                           object.objectToWorld * scale(Vec3(kEndOfPlaneMesh, kEndOfPlaneMesh, 1.0f)));
                return;
            case ShapeKind::Rectangle:
                writeShape(kSquare, object, object.objectToWorld);
                return;
            case ShapeKind::Disc:
                if (isTextured(object)) { warn("approximated: textures lie around the middles of disks"); }
                writeShape("\"disk\"", object, object.objectToWorld);
                return;
            case ShapeKind::Revolved:
                if (isCylinder(object, false)) { return writeCylinder(object); }
                [[fallthrough]];
            default:
                writePly(saveTriangles(object), object);
        }
    }

    /// pbrt's axis is z, Glint's y.
    void writeCylinder(const Object& object) {
        const std::vector<Vec2>& p = object.profile;
        writeShape("\"cylinder\"" + pbrtNumber("radius", p[0].x) + pbrtNumber("zmin", p[1].y) +
                       pbrtNumber("zmax", p[0].y),
                   object, object.objectToWorld * Affine{Mat3(1, 0, 0, 0, 0, -1, 0, 1, 0), Vec3(0.0f)});
    }

    void writeMesh(const Object& object) {
        const MeshData* mesh = meshOf(object);
        if (mesh == nullptr) { return; }
        if (!mesh->colors.empty()) { warn("approximated: vertices have no colours"); }
        if (!mesh->normals.empty() && std::ranges::any_of(mesh->normals, isZero)) {
            warn("approximated: meshes are smooth everywhere or nowhere");
        }
        std::string& name = plys_[object.mesh];
        if (name.empty()) {
            MeshData shown = *mesh;
            shown.colors.clear();
            name = savePly(shown);
        }
        writePly(name, object);
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
        if (absorbsInside(material)) {
            out_ += fmt::format("MediumInterface {} \"\"\n", mediumName(object.material));
        }
        out_ += fmt::format("NamedMaterial {}\nShape {}", pbrtMaterialName(scene_, object.material), shape);
        if (material.opacity.texture >= 0 || material.opacity.value < 1.0f) {
            out_ += pbrtNumberInput("alpha", material.opacity);
        }
        out_ += "\nAttributeEnd\n";
    }

    std::string out_;
    std::map<int, std::string> plys_;
    int images_ = 0;
};

Status save(const SceneDescription& scene, const std::string& path, std::vector<std::string>* warnings) {
    return PbrtExporter(scene, path, warnings).run();
}

bool isOwn(std::string_view head) { return head.starts_with(kOwnMark); }

}  // namespace

extern const Exporter kExportPbrt;
const Exporter kExportPbrt{"pbrt-v4", ".pbrt", save, isOwn};

}  // namespace glint
