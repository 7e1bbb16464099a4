// glTF 2.0 specification, section 3.9, and the KHR_materials extensions: what gltf_materials.cpp reads.
#include <algorithm>
#include <cmath>

#include "engine/io/gltf_anisotropy.h"
#include "engine/io/gltf_export.h"
#include "engine/io/scene_export.h"
#include "engine/scene/metals.h"
#include "engine/scene/scene_use.h"

namespace glint {
namespace {

/// Whether a mesh under that material has tangents of its own.
bool hasTangents(const SceneDescription& scene, int material) {
    return std::ranges::any_of(scene.objects, [&](const Object& object) {
        if (object.material != material || object.shape != ShapeKind::Mesh) { return false; }
        const MeshData* mesh = scene.meshes[static_cast<size_t>(object.mesh)].data.get();
        return mesh != nullptr && !mesh->tangents.empty();
    });
}

class MaterialWriter {
  public:
    MaterialWriter(const SceneDescription& scene, int material, GltfImages* images, GltfWriter* out,
                   std::vector<std::string>* warnings)
        : scene_(scene),
          from_(scene.materials[static_cast<size_t>(material)]),
          isFlipped_(flipsV(scene, material)),
          isTurned_(hasTangents(scene, material) ? !tangentsCountFromTop(scene, material) : isFlipped_),
          images_(*images),
          out_(*out),
          warnings_(*warnings) {}

    GltfJson write(bool isEmitter) {
        if (!from_.name.empty()) { to_["name"] = from_.name; }
        alpha();
        model();
        anisotropy();
        normals();
        if (from_.emissive()) { emission(isEmitter); }
        const bool isBody = isClearBody(from_);
        if (from_.emissive() ? from_.emitsBothSides : !isBody) { to_["doubleSided"] = true; }
        return std::move(to_);
    }

  private:
    void warn(std::string_view sentence) { warnOnce(sentence, &warnings_); }
    const Texture& texture(int index) const { return scene_.textures[static_cast<size_t>(index)]; }
    GltfJson info(int index, GltfImageUse use) { return images_.info(index, -1, use, isFlipped_); }
    GltfJson& pbr() { return to_["pbrMetallicRoughness"]; }

    void alpha() {
        const int color = from_.color.texture, opacity = from_.opacity.texture;
        const auto hasAlpha = [this](int index) {
            return index >= 0 && texture(index).image.bytes && !texture(index).image.bytes->alpha.empty();
        };
        constexpr float kSteep = 1e3f;  // what rises so is there or is not
        if (opacity >= 0 && color >= 0 && texture(opacity).channel == TextureChannel::Alpha &&
            texture(opacity).gain >= kSteep && texture(opacity).image.source == texture(color).image.source) {
            to_["alphaMode"] = "MASK";
            to_["alphaCutoff"] = gltfJson((1.0f - texture(opacity).base) / texture(opacity).gain);
        } else if (opacity >= 0 || from_.opacity.value < 1.0f || (from_.alphaCutsOut && hasAlpha(color))) {
            to_["alphaMode"] = "BLEND";
            opacity_ = opacity >= 0 ? 1.0f : from_.opacity.value;
            alphaTexture_ = opacity;
        }
    }

    void color(const Vec3& factor, int index) {
        GltfJson rgba = gltfJson(glm::clamp(factor, Vec3(0.0f), Vec3(1.0f)));
        rgba.push_back(gltfJson(opacity_));
        pbr()["baseColorFactor"] = std::move(rgba);
        if (index >= 0 || alphaTexture_ >= 0) {
            pbr()["baseColorTexture"] = images_.info(index, alphaTexture_, GltfImageUse::Color, isFlipped_);
        }
    }
    void color() { color(from_.color.texture >= 0 ? Vec3(1.0f) : from_.color.value, from_.color.texture); }

    void surface(float metallic, float roughness) {
        pbr()["metallicFactor"] = gltfJson(metallic);
        pbr()["roughnessFactor"] = gltfJson(roughness);
    }
    /// By the material's own GGX alpha, which is the square of glTF's roughness.
    void surface(float metallic) {
        const int index = from_.roughness.texture;
        surface(metallic, roughnessFactor());
        if (index >= 0) { pbr()["metallicRoughnessTexture"] = info(index, GltfImageUse::Roughness); }
    }
    float roughnessFactor() {
        if (distributionOf(from_) != FacetDistribution::Ggx) {
            warn("approximated: Beckmann's facets are GGX of the same alpha");
        }
        const int index = from_.roughness.texture;
        return index >= 0 ? images_.roughnessFactor(index) : std::sqrt(leastAlpha(from_));
    }
    void anisotropy() {
        if (!isAnisotropic(from_)) { return; }
        if (!isEvenlyAnisotropic(from_) || from_.anisotropyDirection.texture >= 0) {
            warn("approximated: images of anisotropy are left out");
        }
        if (!isEvenlyAnisotropic(from_)) { return; }
        out_.extend(&to_, "KHR_materials_anisotropy", gltfAnisotropy(from_, isTurned_));
    }

    void ior() {
        constexpr float kUsual = 1.5f;
        const float index = oneIor(from_, &warnings_);
        if (index != kUsual) {
            out_.extend(&to_, "KHR_materials_ior", GltfJson::object({{"ior", gltfJson(index)}}));
        }
    }
    /// Nothing but the base: no light is reflected above it, as the one or the other extension says.
    void withoutCoat() {
        surface(0.0f, 1.0f);
        out_.extend(&to_, "KHR_materials_specular", GltfJson::object({{"specularFactor", 0}}));
        out_.extend(&to_, "KHR_materials_ior", GltfJson::object({{"ior", 1}}));
    }

    void model() {
        switch (from_.kind) {
            case MaterialKind::Diffuse:
                color();
                withoutCoat();
                return;
            case MaterialKind::Mirror:
                mirror();
                return;
            case MaterialKind::Conductor:
                metal();
                return;
            case MaterialKind::Dielectric:
                glass();
                return;
            case MaterialKind::Plastic:
            case MaterialKind::Phong:  // withUsualModels() has been there
            case MaterialKind::Ward:
                warn("approximated: light does not go back and forth under coats of plastic");
                color();
                surface(0.0f);
                ior();
                return;
            case MaterialKind::Mixture:
                mixture();
                return;
            case MaterialKind::Translucent:
                sheet();
                return;
            case MaterialKind::Coated:
            case MaterialKind::Principled:
                principled();
                return;
        }
    }

    void principled() {
        color();
        const NumberInput &rough = from_.roughness, &metal = from_.metallic;
        surface(metal.texture >= 0 ? images_.shareFactor(metal.texture) : metal.value, roughnessFactor());
        if (rough.texture >= 0 || metal.texture >= 0) {
            pbr()["metallicRoughnessTexture"] =
                images_.info(rough.texture, metal.texture, GltfImageUse::Roughness, isFlipped_);
        }
        ior();
        writeGltfLayers(from_, isFlipped_, &images_, &out_, &to_, &warnings_);
    }

    void mirror() {
        warn("approximated: mirrors are metals of their colour");
        color();
        surface(1.0f, 0.0f);
    }

    void metal() {
        if (!findMetal(from_.metal) && (from_.eta.texture >= 0 || from_.k.texture >= 0)) {
            warn("approximated: constants of metals are no images");
        }
        const Vec3 r = reflectanceHeadOn(from_);
        constexpr float kWhite = 0.9989f;
        warn("approximated: metals have the colour that they show from the front");
        const bool isTextured = from_.color.texture >= 0;
        const Vec3 white = isTextured && minComponent(r) > kWhite ? Vec3(1.0f) : r;
        color(isTextured ? white : white * from_.color.value, from_.color.texture);
        surface(1.0f);
    }

    void glass() {
        if (from_.color != ColorInput{Vec3(1.0f)}) { warn("approximated: what glass reflects has no tint"); }
        color();
        from_.thin ? surface(0.0f, 0.0f) : surface(0.0f);
        ior();
        out_.extend(&to_, "KHR_materials_transmission", GltfJson::object({{"transmissionFactor", 1}}));
        writeGltfVolume(from_, &out_, &to_);
    }

    void mixture() {
        warn("approximated: mixtures are their heaviest part");
        const Vec3 w = from_.mixtureWeights.value;
        if (w.z >= w.x && w.z >= w.y) {
            glass();
        } else if (w.x >= w.y) {
            color();
            withoutCoat();
        } else {
            mirror();
        }
    }

    /// The share that passes, of a base without it: KHR_materials_diffuse_transmission.
    void sheet() {
        if (from_.transmission.texture >= 0) { warn("approximated: what passes through sheets is no image"); }
        const Vec3 passes = from_.transmission.value;
        const float share = clampf(maxComponent(passes), 0.0f, 1.0f);
        const float rest = std::max(1.0f - share, 1e-6f);
        color(from_.color.texture >= 0 ? Vec3(1.0f) : from_.color.value / rest, from_.color.texture);
        if (from_.color.texture >= 0) { warn("approximated: images of sheets lose the share that passes"); }
        withoutCoat();
        if (share == 0.0f) { return; }
        out_.extend(&to_, "KHR_materials_diffuse_transmission",
                    {{"diffuseTransmissionFactor", gltfJson(share)},
                     {"diffuseTransmissionColorFactor", gltfJson(passes / share)}});
    }

    void normals() {
        if (from_.bump.texture >= 0) { warn("approximated: bump maps are left out"); }
        if (from_.normalMap.texture < 0) { return; }
        to_["normalTexture"] = info(from_.normalMap.texture, GltfImageUse::Normal);
        to_["normalTexture"]["scale"] = gltfJson(from_.normalStrength);
    }

    /// Factors end at 1; powers of two keep the digits.
    void emission(bool isEmitter) {
        const int index = from_.emission.texture;
        Vec3 factor = index >= 0 ? Vec3(1.0f) : from_.emission.value;
        float strength = from_.emissionStrength;
        while (maxComponent(factor) > 1.0f || (isEmitter && strength <= 1.0f)) {
            factor *= 0.5f;
            strength *= 2.0f;
        }
        to_["emissiveFactor"] = gltfJson(factor);
        if (index >= 0) { to_["emissiveTexture"] = info(index, GltfImageUse::Color); }
        if (strength != 1.0f) {
            out_.extend(&to_, "KHR_materials_emissive_strength",
                        GltfJson::object({{"emissiveStrength", gltfJson(strength)}}));
        }
    }

    const SceneDescription& scene_;
    const Material& from_;
    bool isFlipped_, isTurned_;  ///< glTF's v, and the side of tangents, run against the material's
    GltfImages& images_;
    GltfWriter& out_;
    std::vector<std::string>& warnings_;
    GltfJson to_ = GltfJson::object();
    float opacity_ = 1.0f;
    int alphaTexture_ = -1;
};

}  // namespace

bool flipsV(const SceneDescription& scene, int material) {
    const std::vector<int> textures = usedTextures(scene.materials[static_cast<size_t>(material)]);
    return textures.empty()  // as others have the mesh
               ? !std::ranges::any_of(scene.textures, &Texture::flipV)
               : !scene.textures[static_cast<size_t>(textures.front())].flipV;
}

bool tangentsCountFromTop(const SceneDescription& scene, int material) {
    const int normals = scene.materials[static_cast<size_t>(material)].normalMap.texture;
    return normals >= 0 ? scene.textures[static_cast<size_t>(normals)].flipV : !flipsV(scene, material);
}

size_t writeGltfMaterial(const SceneDescription& scene, int material, bool isEmitter, GltfImages* images,
                         GltfWriter* out, std::vector<std::string>* warnings) {
    return out->add("materials", MaterialWriter(scene, material, images, out, warnings).write(isEmitter));
}

}  // namespace glint
