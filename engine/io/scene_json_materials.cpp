// Glint JSON: textures and materials.
#include <algorithm>

#include <fmt/format.h>

#include "engine/base/nearest_name.h"
#include "engine/io/scene_json_keys.h"
#include "engine/io/scene_json_reader.h"
#include "engine/scene/metals.h"

namespace glint {
namespace {

/// In the order of MaterialKind.
constexpr std::string_view kMaterialTypes[] = {"diffuse",    "mirror",  "conductor",
                                               "dielectric", "plastic", "mixture"};
constexpr NumberRange kAlbedo{.lo = 0.0f, .hi = 1.0f, .expected = "a reflectance from 0 to 1 per channel"};
constexpr NumberRange kIor{.lo = 0.01f, .hi = 100.0f, .expected = "an index of refraction from 0.01 to 100"};

}  // namespace

void SceneJsonReader::readTextures(const JsonValue& value) {
    if (!value.present() || !expectType(errors_, value, "textures", JsonType::Object)) { return; }
    forEachMember(errors_, value, [&](const std::string& name, const JsonValue& texture) {
        textureNames_[name] = addTexture(texture, name);
    });
}

int SceneJsonReader::addTexture(const JsonValue& value, const std::string& name) {
    const JsonFields fields = fieldsOf(value, "texture", "texture");
    Texture texture;
    texture.name = name;
    const JsonValue file = fields.require("file");
    FileSource named;
    fields.string("file", &named.path);
    texture.image.source = named;
    constexpr std::pair<std::string_view, ColorEncoding> kEncodings[] = {{"srgb", ColorEncoding::Srgb},
                                                                         {"linear", ColorEncoding::Linear}};
    fields.choice("encoding", kEncodings, &texture.encoding);
    fields.boolean("flipV", &texture.flipV);
    if (const JsonValue scale = fields.find("scale"); scale.present()) {
        readNumbers(errors_, scale, "scale", kAnyNumber, 2, &texture.scale.x);
    }
    if (errors_.failed()) { return -1; }
    texturePlaces_.push_back(file);
    scene_.textures.push_back(std::move(texture));
    return static_cast<int>(scene_.textures.size()) - 1;
}

void SceneJsonReader::readMaterials(const JsonValue& value) {
    if (!value.present() || !expectType(errors_, value, "materials", JsonType::Object)) { return; }
    forEachMember(errors_, value, [&](const std::string& name, const JsonValue& material) {
        Material read = readMaterial(material, name);
        materialNames_[name] = static_cast<int>(scene_.materials.size());
        scene_.materials.push_back(std::move(read));
    });
}

Material SceneJsonReader::readMaterial(const JsonValue& value, const std::string& name) {
    Material material;
    material.name = name;
    const int type = typeOf(value, "material", kMaterialTypes);
    if (type < 0) { return material; }
    material.kind = static_cast<MaterialKind>(type);
    const bool isTint = material.kind == MaterialKind::Mirror || material.kind == MaterialKind::Conductor ||
                        material.kind == MaterialKind::Dielectric;
    material.color.value = Vec3(isTint ? 1.0f : 0.5f);
    const JsonFields fields = fieldsOf(value, kMaterialTypes[type], kMaterialTypes[type]);
    const auto takes = [keys = sceneJsonKeys(kMaterialTypes[type])](std::string_view key) {
        return std::find(keys.begin(), keys.end(), key) != keys.end();
    };
    readInput(fields, "color", kAlbedo, &material.color);
    if (material.kind == MaterialKind::Conductor) { readMetal(fields, &material); }
    if (takes("ior")) { readInput(fields, "ior", kIor, &material.ior); }
    if (takes("roughness")) { readInput(fields, "roughness", kUnitInterval, &material.roughness); }
    if (takes("thin")) { fields.boolean("thin", &material.thin); }
    if (takes("weights")) {
        readInput(fields, "weights", kNotNegative, &material.mixtureWeights);
        if (isZero(material.mixtureWeights.value)) {
            errors_.add(fields.find("weights"),
                        "\"weights\" are all 0; expected [diffuse, mirror, refractive]");
        }
    }
    readInput(fields, "emission", kNotNegative, &material.emission);
    fields.number("emissionStrength", kNotNegative, &material.emissionStrength);
    fields.boolean("emitsBothSides", &material.emitsBothSides);
    return material;
}

void SceneJsonReader::readMetal(const JsonFields& fields, Material* material) {
    const JsonValue metal = fields.find("metal");
    const JsonValue eta = fields.find("eta");
    const JsonValue k = fields.find("k");
    if (metal.present() && (eta.present() || k.present())) {
        errors_.add(metal, "a conductor has either \"metal\" or \"eta\" and \"k\", not both");
    } else if (eta.present() != k.present()) {
        errors_.add(eta.present() ? eta : k, "\"eta\" and \"k\" belong together; expected both");
    } else if (eta.present()) {
        material->metal.clear();
        readInput(fields, "eta", kPositive, &material->eta);
        readInput(fields, "k", kNotNegative, &material->k);
    } else if (metal.present() && readString(errors_, metal, "metal", &material->metal)) {
        const auto known = metalNames();
        if (std::find(known.begin(), known.end(), material->metal) == known.end()) {
            errors_.add(metal,
                        fmt::format("unknown metal \"{}\"{}; expected {}", material->metal.substr(0, 60),
                                    didYouMean(material->metal, known), joinNames(known)));
        }
    }
}

void SceneJsonReader::readInput(const JsonFields& fields, std::string_view key, const NumberRange& range,
                                ColorInput* color) {
    const JsonValue value = fields.find(key);
    if (!value.is(JsonType::Object)) {
        fields.color(key, range, &color->value);
        return;
    }
    const JsonFields use = fieldsOf(value, key, "textureUse");
    use.color("fallback", range, &color->value);
    color->texture = textureUse(use);
}

void SceneJsonReader::readInput(const JsonFields& fields, std::string_view key, const NumberRange& range,
                                NumberInput* number) {
    const JsonValue value = fields.find(key);
    if (!value.is(JsonType::Object)) {
        fields.number(key, range, &number->value);
        return;
    }
    const JsonFields use = fieldsOf(value, key, "textureUse");
    use.number("fallback", range, &number->value);
    number->texture = textureUse(use);
}

int SceneJsonReader::textureUse(const JsonFields& use) {
    const JsonValue texture = use.require("texture");
    return texture.present() ? textureIndex(texture) : -1;
}

int SceneJsonReader::textureIndex(const JsonValue& value) {
    if (value.is(JsonType::Object)) {
        return addTexture(value, fmt::format("texture {}", scene_.textures.size() + 1));
    }
    return findName(textureNames_, value, "texture");
}

int SceneJsonReader::materialIndex(const JsonValue& value, const std::string& ownerName) {
    if (!value.is(JsonType::Object)) { return std::max(0, findName(materialNames_, value, "material")); }
    scene_.materials.push_back(readMaterial(value, "material of " + ownerName));
    return static_cast<int>(scene_.materials.size()) - 1;
}

}  // namespace glint
