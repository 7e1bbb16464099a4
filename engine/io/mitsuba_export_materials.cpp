// Materials and textures as Mitsuba 3 has them: what mitsuba_materials.cpp reads as the same again.
#include <cmath>

#include <fmt/format.h>

#include "engine/io/burley.h"
#include "engine/io/mitsuba_writer.h"
#include "engine/io/scene_export.h"
#include "engine/scene/kind_names.h"
#include "engine/scene/metals.h"

namespace glint {
namespace {

class MaterialWriter {
  public:
    MaterialWriter(const SceneDescription& scene, const MitsubaUse& use, MitsubaWriter* out,
                   std::vector<std::string>* warnings)
        : scene_(scene),
          use_(use),
          material_(scene.materials[static_cast<size_t>(use.material)]),
          out_(*out),
          warnings_(*warnings) {}

    /// Wrappers from the outside in, then the model.
    void write() {
        const bool isCutOut = material_.opacity.texture >= 0 || material_.opacity.value < 1.0f;
        const bool lets = material_.kind == MaterialKind::Dielectric || transmits(material_);
        int open = 0;
        if (isCutOut) {
            begin("mask", &open);
            number("opacity", material_.opacity);
        }
        if (!lets && !use_.isOneSided && material_.kind != MaterialKind::Mixture) {
            begin("twosided", &open);
        }
        if (material_.bump.texture >= 0) {
            begin("bumpmap", &open);
            out_.number("scale", material_.bumpHeight);
            texture("height", material_.bump.texture, true);
        }
        if (material_.normalMap.texture >= 0) {
            if (material_.normalStrength != 1.0f) {
                warn("approximated: normal maps are as strong as they are");
            }
            begin("normalmap", &open);
            texture("normalmap", material_.normalMap.texture, false);
        }
        model(&open);
        for (; open > 0; --open) {
            out_.close();
        }
        if (hasAlpha(material_.opacity.texture)) { warn("approximated: opacity is an image's brightness"); }
        if (material_.alphaCutsOut && hasAlpha(material_.color.texture)) {
            warn("approximated: the alpha of colours does not cut out");
        }
    }

  private:
    void warn(std::string_view sentence) { warnOnce(sentence, &warnings_); }

    void begin(std::string_view type, int* open) {
        const bool isOuter = (*open)++ == 0;
        out_.open("bsdf", isOuter ? fmt::format("type=\"{}\" id=\"{}\"", type, use_.id(scene_))
                                  : fmt::format("type=\"{}\"", type));
    }

    void texture(std::string_view name, int index, bool isNumber) {
        writeMitsubaTexture(scene_.textures[static_cast<size_t>(index)], use_.origin, isNumber, name, &out_,
                            &warnings_);
    }
    void number(std::string_view name, const NumberInput& input) {
        input.texture >= 0 ? texture(name, input.texture, true) : out_.number(name, input.value);
    }
    void color(std::string_view name, const ColorInput& input) {
        input.texture >= 0 ? texture(name, input.texture, false) : out_.color(name, input.value);
    }

    bool hasAlpha(int texture) const {
        if (texture < 0) { return false; }
        const SceneImage& image = scene_.textures[static_cast<size_t>(texture)].image;
        return image.bytes && !image.bytes->alpha.empty();
    }

    /// The words of a rough model's name, and its roughness as a property once it is open.
    std::string rough(std::string_view smooth) const {
        const auto isRoughBy = [](const NumberInput& alpha) {
            return alpha.texture >= 0 || alpha.value > 0.0f;
        };
        const bool isRough = isRoughBy(material_.roughness) || isRoughBy(material_.crossRoughness);
        return fmt::format("{}{}", isRough && !material_.thin ? "rough" : "", smooth);
    }
    void roughness() {
        if (rough("").empty()) { return; }
        out_.string("distribution", nameOf(material_.distribution));
        const UvRoughness alpha = uvRoughness(material_, &warnings_);
        if (alpha.u == alpha.v) {
            number("alpha", alpha.u);
        } else if (material_.kind == MaterialKind::Plastic) {
            warn("approximated: plastic is as rough in all directions");
            NumberInput mean = alpha.u;
            mean.value = std::sqrt(alpha.u.value * alpha.v.value);
            number("alpha", mean);
        } else {
            number("alpha_u", alpha.u);
            number("alpha_v", alpha.v);
        }
    }

    void model(int* open) {
        switch (material_.kind) {
            case MaterialKind::Diffuse:
                begin("diffuse", open);
                diffuseColor();
                return;
            case MaterialKind::Mirror:
                begin("conductor", open);
                out_.string("material", "none");
                color("specular_reflectance", material_.color);
                return;
            case MaterialKind::Conductor:
                begin(rough("conductor"), open);
                metal();
                roughness();
                color("specular_reflectance", material_.color);
                return;
            case MaterialKind::Dielectric:
                begin(material_.thin ? "thindielectric" : rough("dielectric"), open);
                ior();
                roughness();
                color("specular_reflectance", material_.color);
                color("specular_transmittance", material_.color);
                return;
            case MaterialKind::Plastic:
            case MaterialKind::Phong:  // withUsualModels() has been there
            case MaterialKind::Ward:
                begin(rough("plastic"), open);
                ior();
                roughness();
                out_.flag("nonlinear", true);
                color("diffuse_reflectance", material_.color);
                if (!rough("").empty()) {
                    warn("approximated: Mitsuba's rough plastic loses light between its facets");
                }
                return;
            case MaterialKind::Mixture:
                mixture(open);
                return;
            case MaterialKind::Translucent:
                warn("approximated: translucent sheets let nothing through");
                begin("diffuse", open);
                diffuseColor();
                return;
            case MaterialKind::Coated:
            case MaterialKind::Principled:
                principled(open);
                return;
        }
    }

    /// Mitsuba's alpha is its roughness squared.
    void principled(int* open) {
        warn("approximated: principled materials have Mitsuba's lobes");
        const bool isClear = transmits(material_);
        begin(isClear && material_.thin ? "principledthin" : "principled", open);
        color("base_color", material_.color);
        principledRoughness();
        number("metallic", material_.metallic);
        const float root = (material_.ior.value - 1.0f) / (material_.ior.value + 1.0f);
        if (isClear) {
            number("spec_trans", material_.specularTransmission);
            out_.number("eta", material_.ior.value);
        } else {
            out_.number("specular", std::fmin(material_.specular.value * root * root / 0.08f, 1.0f));
        }
        NumberInput coat = material_.clearcoat;
        coat.value = std::fmin(coat.value / kBurleyCoat, 1.0f);
        number("clearcoat", coat);
        out_.number("clearcoat_gloss", burleyCoatGloss(material_.clearcoatRoughness.value));
        const float sheen = maxComponent(material_.sheenColor.value) / kBurleySheen;
        if (sheen > 0.0f) { out_.number("sheen", std::fmin(sheen, 1.0f)); }
    }

    void principledRoughness() {
        const UvRoughness alpha = uvRoughness(material_, &warnings_);
        NumberInput mean = alpha.u;
        mean.value = std::sqrt(std::fmax(alpha.u.value * alpha.v.value, 0.0f));
        number("roughness", squareRoot(mean));
        if (alpha.u == alpha.v) { return; }
        if (alpha.u.texture >= 0 || alpha.v.value > alpha.u.value || alpha.v.value < 0.1f * alpha.u.value) {
            warn("approximated: principled roughness is at most ten times as large along u, and no image");
        }
        out_.number("anisotropic", burleyAnisotropic(alpha.u.value, alpha.v.value));
    }

    static NumberInput squareRoot(NumberInput input) {
        input.value = std::sqrt(std::fmax(input.value, 0.0f));
        return input;
    }

    void diffuseColor() {
        if (!use_.hasColors) {
            color("reflectance", material_.color);
            return;
        }
        if (material_.color.texture >= 0) { warn("approximated: vertex colours take a texture's place"); }
        out_.open("texture", "type=\"mesh_attribute\" name=\"reflectance\"");
        out_.string("name", "vertex_color");
        out_.close();
    }

    void metal() {
        const auto known = findMetal(material_.metal);
        known ? out_.color("eta", known->eta) : color("eta", material_.eta);
        known ? out_.color("k", known->k) : color("k", material_.k);
    }

    void ior() {
        out_.number("int_ior", oneIor(material_, &warnings_));
        out_.number("ext_ior", 1.0f);
    }

    void mixture(int* open) {
        warn("approximated: mixtures are their heaviest part");
        const Vec3 w = material_.mixtureWeights.value;
        if (w.z >= w.x && w.z >= w.y) {
            begin("dielectric", open);
            ior();
            color("specular_transmittance", material_.color);
            color("specular_reflectance", material_.color);
            return;
        }
        begin("twosided", open);
        if (w.x >= w.y) {
            begin("diffuse", open);
            diffuseColor();
        } else {
            begin("conductor", open);
            color("specular_reflectance", material_.color);
        }
    }

    const SceneDescription& scene_;
    const MitsubaUse& use_;
    const Material& material_;
    MitsubaWriter& out_;
    std::vector<std::string>& warnings_;
};

/// Glint's placement as Mitsuba's, whose v runs down from the image's top row: uv of the shape as Mitsuba has
/// them go in, and out comes the place in the image.
Affine toUv(const Texture& texture, UvOrigin origin) {
    const float angle = texture.rotationDeg * (kPi / 180.0f), c = std::cos(angle), s = std::sin(angle);
    const Affine turn{Mat3(c, s, 0, -s, c, 0, 0, 0, 1), Vec3(texture.offset, 0.0f)};
    const Affine flip{Mat3(1, 0, 0, 0, -1, 0, 0, 0, 1), Vec3(0, 1, 0)};
    const Affine own = (texture.rotationDeg == 0.0f ? translate(Vec3(texture.offset, 0.0f)) : turn) *
                       scale(Vec3(texture.scale, 1.0f));
    const Affine placed = texture.flipV ? own : flip * own;
    return origin == UvOrigin::Bottom ? placed * flip : placed;
}

}  // namespace

void writeMitsubaMaterial(const SceneDescription& scene, const MitsubaUse& use, MitsubaWriter* out,
                          std::vector<std::string>* warnings) {
    MaterialWriter(scene, use, out, warnings).write();
}

void writeMitsubaTexture(const Texture& texture, UvOrigin origin, bool isNumber, std::string_view name,
                         MitsubaWriter* out, std::vector<std::string>* warnings) {
    const auto* board = std::get_if<Checkerboard>(&texture.image.source);
    out->open("texture",
              fmt::format("type=\"{}\" name=\"{}\"", board != nullptr ? "checkerboard" : "bitmap", name));
    const Affine place = toUv(texture, origin);
    if (!(place == Affine())) { out->matrix("to_uv", place); }
    if (board != nullptr) {
        out->color("color0", board->even);
        out->color("color1", board->odd);
        out->close();
        return;
    }
    out->string("filename", pathOf(texture.image.source));
    if (isNumber || texture.encoding == ColorEncoding::Linear) { out->flag("raw", true); }
    const auto wordOf = [](WrapMode wrap) {
        return wrap == WrapMode::Clamp ? "clamp" : wrap == WrapMode::Mirror ? "mirror" : "repeat";
    };
    if (texture.wrapU != WrapMode::Repeat) { out->string("wrap_mode", wordOf(texture.wrapU)); }
    if (texture.wrapU != texture.wrapV) { warnOnce("approximated: images wrap alike in u and v", warnings); }
    if (texture.filter == TexelFilter::Nearest) { out->string("filter_type", "nearest"); }
    if (texture.base != 0.0f || texture.gain != 1.0f || texture.exponent != 1.0f) {
        warnOnce("approximated: images are shown as they are stored", warnings);
    }
    out->close();
}

}  // namespace glint
