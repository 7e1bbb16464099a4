// Materials as pbrt-v4 has them: what pbrt_materials.cpp reads as the same again.
#include <fmt/format.h>

#include "engine/io/pbrt_color.h"
#include "engine/io/pbrt_writer.h"
#include "engine/io/scene_export.h"
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
        const std::string flag = pbrtFlag("remaproughness", false);
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
        return pbrtString("type", "coatedconductor") + color + roughness("conductor.") +
               pbrtNumberInput("interface.roughness", material_.clearcoatRoughness);
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
