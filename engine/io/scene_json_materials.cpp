// Glint JSON: textures and materials.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "engine/base/nearest_name.h"
#include "engine/io/scene_json_fields.h"

namespace glint {
void SceneJsonReader::readTextures(const JsonValue& value) {
    if (!value.present() || !expectType(errors_, value, "textures", JsonType::Object)) { return; }
    forEachMember(errors_, value, [&](const std::string& name, const JsonValue& texture) {
        textureNames_[name] = addTexture(texture, name);
    });
}

int SceneJsonReader::addTexture(const JsonValue& value, const std::string& name) {
    Texture texture;
    texture.name = name;
    bool isGenerated = false;
    if (value.is(JsonType::Object)) {
        forEachMember(errors_, value,
                      [&](const std::string& key, const JsonValue&) { isGenerated |= key == "generator"; });
    }
    const uint32_t kind = isGenerated ? FieldsOf<Texture>::kGenerated : FieldsOf<Texture>::kInFile;
    std::vector<std::string_view> keys = fieldKeys<Texture>(kind);
    if (isGenerated) {
        keys = fieldKeys<Checkerboard>(~0u, std::move(keys));
        keys.insert(keys.begin(), "generator");
        texture.filter = TexelFilter::Nearest;
    }
    const JsonFields fields = fieldsOf(value, "texture", std::move(keys));
    readFields(fields, kind, &texture);
    if (isGenerated) {
        Checkerboard board;
        fields.word("generator", std::array<std::string_view, 1>{"checkerboard"});
        readFields(fields, ~0u, &board);
        texture.image.source = board;
    }
    if (errors_.failed()) { return -1; }
    texturePlaces_.push_back(isGenerated ? value : fields.find("file"));
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
    const std::optional<MaterialKind> kind = kindOf<MaterialKind>(value, "material");
    if (!kind) { return material; }
    material.kind = *kind;
    const JsonFields fields = fieldsOf(value, nameOf(*kind), fieldKeys<Material>(only(*kind)));
    if (hasMetal(material)) { checkMetal(fields, &material); }
    if (hasGlass(material)) { checkGlass(fields); }
    readFields(fields, only(*kind), &material);
    return material;
}

void SceneJsonReader::checkMetal(const JsonFields& fields, Material* material) {
    const JsonValue metal = fields.find("metal");
    const JsonValue eta = fields.find("eta");
    const JsonValue k = fields.find("k");
    if (metal.present() && (eta.present() || k.present())) {
        errors_.add(metal, "a metal has either \"metal\" or \"eta\" and \"k\", not both");
    } else if (eta.present() != k.present()) {
        errors_.add(eta.present() ? eta : k, "\"eta\" and \"k\" belong together; expected both");
    } else if (eta.present()) {
        material->metal.clear();
    } else {
        checkName(metal, "metal", metalNames());
    }
}

void SceneJsonReader::checkGlass(const JsonFields& fields) {
    const JsonValue glass = fields.find("glass");
    const JsonValue iorRgb = fields.find("iorRgb");
    for (const char* key : {"ior", "abbeNumber"}) {
        const JsonValue value = fields.find(key);
        if (value.present() && (glass.present() || iorRgb.present())) {
            errors_.add(value, fmt::format("\"{}\" says already how light is bent; expected one of the two",
                                           glass.present() ? "glass" : "iorRgb"));
        }
    }
    if (glass.present() && iorRgb.present()) {
        errors_.add(iorRgb, "a material has either \"glass\" or \"iorRgb\", not both");
    }
    checkName(glass, "glass", glassNames());
}

void SceneJsonReader::checkName(const JsonValue& value, std::string_view key,
                                const std::vector<std::string_view>& known) {
    std::string name;
    if (!value.present() || !readString(errors_, value, key, &name)) { return; }
    if (std::ranges::find(known, name) == known.end()) {
        errors_.add(value, fmt::format("unknown {} \"{}\"{}; expected {}", key, name.substr(0, 60),
                                       didYouMean(name, known), joinNames(known)));
    }
}

void SceneJsonReader::readInput(const JsonFields& fields, std::string_view key, const NumberRange& range,
                                ColorInput* color) {
    const JsonValue value = fields.find(key);
    if (!value.is(JsonType::Object)) {
        fields.color(key, range, &color->value);
        return;
    }
    const JsonFields use = fieldsOf(value, key, formKeys("textureUse"));
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
    const JsonFields use = fieldsOf(value, key, formKeys("textureUse"));
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
