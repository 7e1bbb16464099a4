// Mitsuba 3 XML, so that a scene can be checked against that program. What import_mitsuba.cpp reads as the
// same again; engine/io/README.md says what is approximated.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>

#include "engine/io/atomic_file.h"
#include "engine/io/exporter.h"
#include "engine/io/mitsuba_environment.h"
#include "engine/io/mitsuba_writer.h"
#include "engine/io/projected_image.h"
#include "engine/io/scene_export.h"
#include "engine/scene/kind_names.h"
#include "engine/scene/scene_use.h"
#include "engine/scene/shape_forms.h"

namespace glint {
namespace {

/// The file's first line.
constexpr std::string_view kOwnMark = "<!-- Written by Glint. -->\n";

class MitsubaExporter : public SceneExport {
  public:
    MitsubaExporter(SceneDescription scene, const std::string& path, std::vector<std::string>* warnings)
        : SceneExport(std::move(scene), path, warnings) {}

    Status run() {
        placeTextures();
        out_.open("scene", "version=\"3.0.0\"");
        writeMitsubaView(scene_, &out_, &warnings_);
        writeLights();
        for (const MitsubaUse& use : uses()) {
            writeMitsubaMaterial(scene_, use, &out_, &warnings_);
        }
        for (size_t i = 0; i < scene_.objects.size() && status_; ++i) {
            if (isBack(i)) { continue; }
            const bool hasBack = i + 1 < scene_.objects.size() && isBack(i + 1);
            if (scene_.objects[i].frontOnly && !hasBack) {
                warn("approximated: what is seen from its front alone is black from behind");
            }
            writeObject(scene_.objects[i]);
        }
        out_.close();
        return status_ ? writeFileAtomically(path_, std::string(kOwnMark) + out_.text()) : status_;
    }

  private:
    void writeLights() {
        for (Light light : scene_.lights) {
            if (light.kind == LightKind::Projector) {
                writeProjector(light);
                continue;
            }
            if (light.kind == LightKind::Goniometric) {
                warn(lostImage(light.kind));
                light = withoutImage(scene_, light);
            }
            // Its words for these are those of Glint's scene files.
            out_.open("emitter", fmt::format("type=\"{}\"", nameOf(light.kind)));
            const Vec3 color = light.strength * light.color;
            if (light.kind == LightKind::Directional) {
                out_.element("vector",
                             fmt::format("name=\"direction\" value=\"{}\"", xmlNumbers(light.direction)));
                out_.color("irradiance", color);
            } else {
                out_.color("intensity", color);
            }
            if (light.kind == LightKind::Point) {
                out_.element("point",
                             fmt::format("name=\"position\" value=\"{}\"", xmlNumbers(light.position)));
            }
            if (light.kind == LightKind::Spot) { writeSpot(light); }
            out_.close();
        }
        if (scene_.environment.emissive()) { writeEnvironment(); }
    }

    /// Its image alone says how wide the picture is.
    void writeProjector(const Light& light) {
        const int index = light.image.texture;
        const Texture* texture = index >= 0 ? &scene_.textures[static_cast<size_t>(index)] : nullptr;
        const float aspect = texture != nullptr ? aspectOf(texture->image) : 1.0f;
        const Vec3 color = light.strength / kPi * light.color;  // Mitsuba counts so
        out_.open("emitter", "type=\"projector\"");
        out_.open("transform", "name=\"to_world\"");
        out_.element("lookat",
                     fmt::format("origin=\"{}\" target=\"{}\" up=\"{}\"", xmlNumbers(light.position),
                                 xmlNumbers(light.position + light.direction),
                                 xmlNumbers(glm::cross(imageRight(light), light.direction))));
        out_.close();
        out_.number("fov", light.fovDeg);
        if (std::fabs(aspect - light.aspect) > 1e-4f * aspect) {
            warn("approximated: projectors' pixels are square");
        }
        if (texture == nullptr) {
            out_.color("irradiance", color * light.image.value);
        } else {
            writeMitsubaTexture(*texture, UvOrigin::Bottom, false, "irradiance", &out_, &warnings_);
            out_.number("scale", maxComponent(color));
            if (minComponent(color) != maxComponent(color)) {
                warn("approximated: projectors' pictures are not tinted");
            }
        }
        out_.close();
    }

    void writeSpot(const Light& light) {
        out_.open("transform", "name=\"to_world\"");
        out_.element("lookat", fmt::format("origin=\"{}\" target=\"{}\"", xmlNumbers(light.position),
                                           xmlNumbers(light.position + light.direction)));
        out_.close();
        out_.number("cutoff_angle", light.coneAngleDeg);
        out_.number("beam_width", light.coneFalloffStartDeg);
        if (light.coneFalloffStartDeg < light.coneAngleDeg) { warn("approximated: spots fall off linearly"); }
    }

    void writeEnvironment() {
        const Environment& environment = scene_.environment;
        const Vec3 color = environment.strength * environment.color;
        if (!environment.portal.empty()) {
            warn("approximated: environments shine from everywhere, not through their portals alone");
        }
        if (environment.image < 0) {
            out_.open("emitter", "type=\"constant\"");
            out_.color("radiance", color);
            out_.close();
            return;
        }
        warn("approximated: the environment's rows are laid out anew");
        const std::shared_ptr<const ImageF> image = environmentImage();
        if (image == nullptr) { return; }
        const std::string name = saveEnvironment(withRowsAtPoles(*image), color);
        out_.open("emitter", "type=\"envmap\"");
        out_.string("filename", name);
        out_.matrix("to_world", rotate(Vec3(0, 1, 0), (environment.rotationDeg - 180.0f) * (kPi / 180.0f)));
        out_.close();
    }

    bool hasColors(const Object& object) const {
        if (object.shape != ShapeKind::Mesh) { return false; }
        const auto& data = scene_.meshes[static_cast<size_t>(object.mesh)].data;
        return data && !data->colors.empty();
    }
    MitsubaUse useOf(const Object& object) const {
        const bool isFlat = object.shape == ShapeKind::Rectangle || object.shape == ShapeKind::Disc;
        return {object.material, isFlat ? UvOrigin::Top : UvOrigin::Bottom, object.frontOnly,
                hasColors(object)};
    }
    std::set<MitsubaUse> uses() const {
        std::set<MitsubaUse> uses;
        for (size_t i = 0; i < scene_.objects.size(); ++i) {
            if (!isBack(i)) { uses.insert(useOf(scene_.objects[i])); }
        }
        return uses;
    }

    /// Whether an object is the black back of the one before it, which Mitsuba's one-sided surfaces have.
    bool isBack(size_t i) const {
        const Object& back = scene_.objects[i];
        if (i == 0 || !back.frontOnly || !scene_.objects[i - 1].frontOnly) { return false; }
        const Material& material = materialOf(back);
        return material.kind == MaterialKind::Diffuse && isZero(material.color.value) &&
               material.color.texture < 0 && !material.emissive() &&
               back.objectToWorld.translation == scene_.objects[i - 1].objectToWorld.translation;
    }

    void writeObject(const Object& object) {
        switch (object.shape) {
            case ShapeKind::Mesh:
                writeMesh(object);
                return;
            case ShapeKind::Sphere:
                writeSphere(object);
                return;
            case ShapeKind::Plane:
                warn("approximated: endless planes end");
                if (isTextured(object)) { return writeTriangles(savePly(shapeMesh(object)), object); }
                writeShape("rectangle", object,
                           object.objectToWorld * scale(Vec3(kEndOfPlaneMesh, kEndOfPlaneMesh, 1.0f)));
                return;
            case ShapeKind::Rectangle:
            case ShapeKind::Disc:
                writeShape(object.shape == ShapeKind::Disc ? "disk" : "rectangle", object,
                           object.objectToWorld);
                return;
            case ShapeKind::Revolved:
                if (isCylinder(object, true)) { return writeCylinder(object); }
                [[fallthrough]];
            default:
                writeTriangles(saveTriangles(object), object);
        }
    }

    void writeTriangles(const std::string& name, const Object& object) {
        writeShape("ply", object, object.objectToWorld, [&] { writePlyFile(name, true); });
    }

    /// Glint's north is +y, Mitsuba's +z; it matters to textures and directions of roughness alone.
    void writeSphere(const Object& object) {
        const bool looksAtUv = isAnisotropic(materialOf(object)) || isTextured(object);
        const Affine toGlint{Mat3(0, 0, -1, -1, 0, 0, 0, 1, 0), Vec3(0.0f)};
        writeShape("sphere", object, looksAtUv ? object.objectToWorld * toGlint : object.objectToWorld);
    }

    /// Mitsuba's axis is z, Glint's y.
    void writeCylinder(const Object& object) {
        const std::vector<Vec2>& p = object.profile;
        const Affine fromZ{Mat3(1, 0, 0, 0, 0, -1, 0, 1, 0), Vec3(0.0f, p[0].y, 0.0f)};
        writeShape("cylinder", object, object.objectToWorld * fromZ, [&] {
            out_.number("radius", p[0].x);
            out_.element("point", fmt::format("name=\"p1\" x=\"0\" y=\"0\" z=\"{}\"", p[1].y - p[0].y));
        });
    }

    void writeMesh(const Object& object) {
        const MeshData* mesh = meshOf(object);
        if (mesh == nullptr) { return; }
        const Vec3 factor = hasColors(object) ? materialOf(object).color.value : Vec3(1.0f);
        std::string& name = plys_[{object.mesh, {factor.x, factor.y, factor.z}}];
        if (name.empty()) {
            MeshData shown = *mesh;
            std::ranges::for_each(shown.colors, [&](Vec3& color) { color *= factor; });
            name = savePly(shown);
        }
        const bool isSmooth = !mesh->normals.empty(),
                   isFacetedToo = std::ranges::any_of(mesh->normals, isZero);
        if (isFacetedToo) { warn("approximated: meshes are smooth everywhere or nowhere"); }
        // A mirror turns the normals that Mitsuba computes, but not the front of Glint's meshes.
        const bool isTurned = !isSmooth && object.objectToWorld.determinant() < 0.0f;
        writeShape("ply", object, object.objectToWorld, [&] { writePlyFile(name, isSmooth, isTurned); });
    }

    void writePlyFile(const std::string& name, bool isSmooth, bool isTurned = false) {
        out_.string("filename", name);
        out_.flag("flip_tex_coords", true);
        if (!isSmooth) { out_.flag("face_normals", true); }
        if (isTurned) { out_.flag("flip_normals", true); }
    }

    template <class More = void (*)()>
    void writeShape(
        std::string_view type, const Object& object, const Affine& toWorld, const More& more = [] {}) {
        out_.open("shape", fmt::format("type=\"{}\"", type));
        more();
        if (!(toWorld == Affine())) { out_.matrix("to_world", toWorld); }
        const MitsubaUse use = useOf(object);
        out_.element("ref", fmt::format("id=\"{}\"", use.id(scene_)));
        const Material& material = materialOf(object);
        if (absorbsInside(material)) {
            out_.open("medium", "name=\"interior\" type=\"homogeneous\"");
            out_.color("sigma_t", absorptionOf(material));
            out_.number("albedo", 0.0f);
            out_.close();
        }
        if (material.emissive()) {
            if (material.emitsBothSides) {
                warn("approximated: what shines on both sides shines on its front");
            }
            out_.open("emitter", "type=\"area\"");
            if (material.emission.texture >= 0) {
                if (material.emissionStrength != 1.0f) {
                    warn("approximated: images shine with a strength of 1");
                }
                writeMitsubaTexture(scene_.textures[static_cast<size_t>(material.emission.texture)],
                                    use.origin, false, "radiance", &out_, &warnings_);
            } else {
                out_.color("radiance", material.emissionStrength * material.emission.value);
            }
            out_.close();
        }
        out_.close();
    }

    MitsubaWriter out_;
    std::map<std::pair<int, std::array<float, 3>>, std::string> plys_;
};

Status save(const SceneDescription& scene, const std::string& path, std::vector<std::string>* warnings) {
    return MitsubaExporter(scene, path, warnings).run();
}

bool isOwn(std::string_view head) { return head.starts_with(kOwnMark); }

}  // namespace

extern const Exporter kExportMitsuba;
const Exporter kExportMitsuba{"Mitsuba 3", ".xml", save, isOwn};

}  // namespace glint
