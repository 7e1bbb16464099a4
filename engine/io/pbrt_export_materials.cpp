// Materials as pbrt-v4 has them: what pbrt_materials.cpp reads as the same again.
#include <cmath>

#include <fmt/format.h>

#include "engine/io/pbrt_color.h"
#include "engine/io/pbrt_writer.h"
#include "engine/io/scene_export.h"
#include "engine/math/color.h"
#include "engine/scene/glasses.h"
#include "engine/scene/metals.h"

namespace glint {
namespace {

class MaterialWriter {
  public:
    MaterialWriter(const SceneDescription& scene, const Material& material,
                   std::vector<std::string>* warnings)
        : scene_(scene), material_(material), warnings_(*warnings) {}

    std::string model() {
        const std::string rough = roughness("");
        switch (material_.kind) {
            case MaterialKind::Diffuse:
                return diffuse();
            case MaterialKind::Mirror:
                return mirror();
            case MaterialKind::Conductor:
                return pbrtString("type", "conductor") + metal() + rough;
            case MaterialKind::Dielectric:
                return dielectric() + (material_.thin ? std::string() : rough);
            case MaterialKind::Plastic:
            case MaterialKind::Phong:  // withUsualModels() has been there
            case MaterialKind::Ward:
                return pbrtString("type", "coateddiffuse") + pbrtColorInput("reflectance", material_.color) +
                       pbrtNumber("eta", index()) + rough;
            case MaterialKind::Translucent:
                return pbrtString("type", "diffusetransmission") +
                       pbrtColorInput("reflectance", material_.color) +
                       pbrtColorInput("transmittance", material_.transmission);
            case MaterialKind::Coated:
                return coatedMetal();
            case MaterialKind::Principled:
                return principled(rough);
            case MaterialKind::Mixture:
                break;
        }
        warn("approximated: mixtures are their heaviest part");
        const Vec3 w = material_.mixtureWeights.value;
        return w.z >= w.x && w.z >= w.y ? dielectric() : w.x >= w.y ? diffuse() : mirror();
    }

    std::string relief() {
        std::string out;
        if (material_.bump.texture >= 0) {
            if (material_.bumpHeight != 1.0f) {
                out += fmt::format(" \"texture displacement\" \"{}h\"",
                                   pbrtTextureName(material_.bump.texture, true));
            } else {
                out += pbrtNumberInput("displacement", material_.bump);
            }
        }
        if (material_.normalMap.texture >= 0) {
            const Texture& map = scene_.textures[static_cast<size_t>(material_.normalMap.texture)];
            if (material_.normalStrength != 1.0f || map.isPlaced() || map.flipV || map.scale != Vec2(1.0f)) {
                warn("approximated: normal maps lie as they are, with their own strength");
            }
            out += pbrtString("normalmap", pathOf(map.image.source));
        }
        return out;
    }

  private:
    void warn(std::string_view sentence) { warnOnce(sentence, &warnings_); }

    std::string roughness(const std::string& prefix) {
        std::string flag = pbrtFlag("remaproughness", false);
        if (!hasFacets(material_.kind)) { return flag; }
        if (distributionOf(material_) != FacetDistribution::Ggx) {
            warn("approximated: Beckmann's facets are GGX of the same alpha");
        }
        const UvRoughness alpha = uvRoughness(material_, &warnings_);
        if (alpha.u == alpha.v) { return pbrtNumberInput(prefix + "roughness", alpha.u) + flag; }
        return pbrtNumberInput(prefix + "uroughness", alpha.u) +
               pbrtNumberInput(prefix + "vroughness", alpha.v) + flag;
    }

    std::string diffuse() const {
        return pbrtString("type", "diffuse") + pbrtColorInput("reflectance", material_.color);
    }

    std::string principled(const std::string& rough) {
        warn("approximated: principled materials are metals or coated diffuse ones");
        if (transmits(material_) && material_.specularTransmission.value >= 0.5f &&
            material_.metallic.value < 0.5f) {
            return dielectric() + rough;
        }
        const std::string color = pbrtColorInput("reflectance", material_.color);
        if (material_.metallic.value < 0.5f) {
            return pbrtString("type", "coateddiffuse") + color + pbrtNumber("eta", index()) + rough;
        }
        if (material_.clearcoat.value < 0.5f) { return pbrtString("type", "conductor") + color + rough; }
        constexpr float kCoat = 1.5f;
        return pbrtString("type", "coatedconductor") +
               (material_.color.texture >= 0 ? color : reflecting(material_.color.value, kCoat)) +
               roughness("conductor.") + pbrtNumber("interface.eta", kCoat) +
               pbrtNumberInput("interface.roughness", material_.clearcoatRoughness) +
               pbrtNumber("thickness", 0.0f);
    }

    std::string coatedMetal() {
        warn("approximated: light goes back and forth under coats over metal");
        if (material_.clearcoatRoughness != NumberInput{0.0f}) {
            warn("approximated: rough coats over metal broaden what passes them");
        }
        const Vec3& absorbed = material_.coatAbsorption.value;
        const bool isGrey = absorbed.x == absorbed.y && absorbed.y == absorbed.z;
        if (!isGrey || material_.coatAbsorption.texture >= 0) {
            warn("approximated: coats over metal absorb all colours alike, everywhere");
        }
        const float ior = index();
        return pbrtString("type", "coatedconductor") + metalUnder(ior) + roughness("conductor.") +
               pbrtNumber("interface.eta", ior) +
               pbrtNumberInput("interface.roughness", material_.clearcoatRoughness) +
               pbrtNumber("thickness", isGrey ? absorbed.x : luminance(absorbed));
    }

    /// Under a coat of that index.
    std::string metalUnder(float coat) {
        if (material_.color.texture >= 0 || material_.color.value != Vec3(1.0f)) {
            warn("approximated: tinted metals under coats have the colour that they show from the front");
        }
        if (material_.color.texture >= 0) { return pbrtColorInput("reflectance", material_.color); }
        if (material_.color.value != Vec3(1.0f)) {
            return reflecting(material_.color.value * reflectanceHeadOn(material_), coat);
        }
        if (const auto known = findMetal(material_.metal)) { return constants(known->eta, known->k, coat); }
        if (material_.eta.texture >= 0 || material_.k.texture >= 0) {
            warn("approximated: constants of metals under coats are no images");
        }
        return constants(material_.eta.value, material_.k.value, coat);
    }

    /// What reflects so much of light from the front within a coat of that index.
    static std::string reflecting(const Vec3& reflectance, float coat) {
        const Vec3 r = glm::clamp(reflectance, Vec3(0.0f), Vec3(0.9999f));
        return constants(Vec3(1.0f), 2.0f * glm::sqrt(r / (Vec3(1.0f) - r)), coat);
    }

    /// By name where they are a metal's that pbrt knows, else such that they are the same over the index.
    static std::string constants(const Vec3& eta, const Vec3& k, float index) {
        for (const std::string_view symbol : {"Ag", "Al", "Au", "Cu", "CuZn"}) {
            const std::string name = fmt::format("metal-{}", symbol);
            const auto known = findMetal(pbrtMetal(name + "-k"));
            if (known && known->eta / index == eta && known->k / index == k) {
                return fmt::format(" \"spectrum conductor.eta\" \"{}-eta\" \"spectrum conductor.k\" \"{}-k\"",
                                   name, name);
            }
        }
        const auto timesIndex = [index](Vec3 value) {
            for (int c = 0; c < 3; ++c) {
                const float product = value[c] * index, less = std::nextafter(product, 0.0f),
                            more = std::nextafter(product, kInfinity);
                value[c] = product / index == value[c] ? product
                           : less / index == value[c]  ? less
                           : more / index == value[c]  ? more
                                                       : product;
            }
            return value;
        };
        return pbrtRgb("conductor.eta", timesIndex(eta)) + pbrtRgb("conductor.k", timesIndex(k));
    }

    std::string mirror() {
        warn("approximated: mirrors are metals of their colour");
        return pbrtString("type", "conductor") + pbrtColorInput("reflectance", material_.color);
    }

    std::string metal() {
        if (material_.color.texture >= 0 || material_.color.value != Vec3(1.0f)) {
            warn("approximated: metals have no tint");
        }
        for (const std::string_view symbol : {"Ag", "Al", "Au", "Cu", "CuZn"}) {
            const std::string name = fmt::format("metal-{}", symbol);
            if (!material_.metal.empty() && pbrtMetal(name + "-k") == material_.metal) {
                return fmt::format(" \"spectrum eta\" \"{}-eta\" \"spectrum k\" \"{}-k\"", name, name);
            }
        }
        const auto known = findMetal(material_.metal);
        return known ? pbrtRgb("eta", known->eta) + pbrtRgb("k", known->k)
                     : pbrtColorInput("eta", material_.eta) + pbrtColorInput("k", material_.k);
    }

    float index() {
        if (material_.ior.texture >= 0) { warn("approximated: indices of refraction are constant"); }
        return material_.ior.value;
    }

    std::string dielectric() {
        if (material_.color.texture >= 0 || material_.color.value != Vec3(1.0f)) {
            warn("approximated: glass has no tint");
        }
        const std::string out = pbrtString("type", material_.thin ? "thindielectric" : "dielectric");
        if (const std::string_view spectrum = pbrtSpectrumOfGlass(material_.glass); !spectrum.empty()) {
            return out + fmt::format(" \"spectrum eta\" \"{}\"", spectrum);
        }
        if (const auto known = findGlass(material_.glass)) {
            warn("approximated: glass that pbrt does not know does not disperse");
            return out + pbrtNumber("eta", known->ior);
        }
        if (!isZero(material_.iorRgb)) { return out + pbrtRgb("eta", material_.iorRgb); }
        if (material_.abbeNumber > 0.0f) {
            warn("approximated: glass that pbrt does not know does not disperse");
        }
        return out + pbrtNumber("eta", index());
    }

    const SceneDescription& scene_;
    const Material& material_;
    std::vector<std::string>& warnings_;
};

}  // namespace

std::string pbrtMaterialName(const SceneDescription& scene, int index) {
    return pbrtQuoted(fmt::format("m{} {}", index, scene.materials[static_cast<size_t>(index)].name));
}

std::string pbrtMaterial(const SceneDescription& scene, int index, std::vector<std::string>* warnings) {
    const Material& material = scene.materials[static_cast<size_t>(index)];
    MaterialWriter writer(scene, material, warnings);
    std::string out;
    if (material.bump.texture >= 0 && material.bumpHeight != 1.0f) {  // in the scene's unit
        const std::string heights = pbrtTextureName(material.bump.texture, true);
        out = fmt::format("Texture \"{}h\" \"float\" \"scale\" \"texture tex\" \"{}\"", heights, heights) +
              pbrtNumber("scale", material.bumpHeight) + "\n";
    }
    const auto hasAlpha = [&](int texture) {
        if (texture < 0) { return false; }
        const SceneImage& image = scene.textures[static_cast<size_t>(texture)].image;
        return image.bytes && !image.bytes->alpha.empty();
    };
    if (material.alphaCutsOut && hasAlpha(material.color.texture)) {
        warnOnce("approximated: the alpha of colours does not cut out", warnings);
    }
    return out + "MakeNamedMaterial " + pbrtMaterialName(scene, index) + writer.model() + writer.relief() +
           "\n";
}

}  // namespace glint
