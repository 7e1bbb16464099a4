#include "engine/io/scene_schema.h"

#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "engine/io/json_value.h"
#include "engine/io/scene_json_keys.h"
#include "engine/scene/field_text.h"
#include "engine/scene/kind_names.h"
#include "engine/scene/shape_forms.h"

namespace glint {
namespace {

constexpr std::string_view kHead = R"({
  "$schema": "http://json-schema.org/draft-07/schema#",
  "$id": "glint.schema.json",
  "title": "Glint scene",
  "description": "A scene for Glint. Comments are allowed. Colours are linear Rec.709. See scenes/README.md.",
  "allOf": [{ "$ref": "#/definitions/scene" }],
  "definitions": {
    "vec3": { "type": "array", "minItems": 3, "maxItems": 3, "items": { "type": "number" } },
    "vec2": { "type": "array", "minItems": 2, "maxItems": 2, "items": { "type": "number" } },
    "reflectance": {
      "description": "A grey level or [r, g, b], linear and from 0 to 1, or \"#rrggbb\" in sRGB.",
      "anyOf": [
        { "type": "number", "minimum": 0, "maximum": 1 },
        { "type": "array", "minItems": 3, "maxItems": 3, "items": { "type": "number", "minimum": 0, "maximum": 1 } },
        { "type": "string", "pattern": "^#[0-9a-fA-F]{6}$" }
      ]
    },
    "radiance": {
      "description": "A grey level or [r, g, b], linear and not negative, or \"#rrggbb\" in sRGB.",
      "anyOf": [
        { "type": "number", "minimum": 0 },
        { "type": "array", "minItems": 3, "maxItems": 3, "items": { "type": "number", "minimum": 0 } },
        { "type": "string", "pattern": "^#[0-9a-fA-F]{6}$" }
      ]
    })";

/// Values whose form has code of its own, by owner and key.
std::string_view customSchema(const Object*, std::string_view key) {
    return key == "material"
               ? R"("anyOf": [{ "type": "string" }, { "$ref": "#/definitions/anyMaterial" }])"
               : R"("description": "Steps, the first listed applied first, after center, radius and the like.", )"
                 R"("anyOf": [{ "$ref": "#/definitions/transformStep" }, )"
                 R"({ "type": "array", "items": { "$ref": "#/definitions/transformStep" } }])";
}
std::string_view customSchema(const Environment*, std::string_view) {
    return R"("oneOf": [{ "$ref": "#/definitions/environmentFile" }, { "$ref": "#/definitions/sky" }])";
}
std::string_view customSchema(const SceneDescription*, std::string_view key) {
    static const std::map<std::string_view, std::string_view> kParts{
        {"resolution", R"("description": "[width, height] in pixels.", "type": "array", "minItems": 2, )"
                       R"("maxItems": 2, "items": { "type": "integer", "minimum": 1, "maximum": 32768 })"},
        {"camera", R"("$ref": "#/definitions/camera")"},
        {"render", R"("$ref": "#/definitions/render")"},
        {"textures", R"("description": "Textures by name.", "type": "object", )"
                     R"("additionalProperties": { "$ref": "#/definitions/texture" })"},
        {"materials", R"("description": "Materials by name.", "type": "object", )"
                      R"("additionalProperties": { "$ref": "#/definitions/anyMaterial" })"},
        {"meshes", R"("description": "Meshes by name.", "type": "object", )"
                   R"("additionalProperties": { "$ref": "#/definitions/anyMesh" })"},
        {"objects", R"("type": "array", "items": { "$ref": "#/definitions/anyObject" })"},
        {"lights",
         R"("description": "Lights without a shape. Shapes shine through their material's emission.", )"
         R"("type": "array", "items": { "$ref": "#/definitions/anyLight" })"},
        {"environment", R"("$ref": "#/definitions/environment")"}};
    const auto part = kParts.find(key);
    return part == kParts.end() ? std::string_view() : part->second;
}

/// `"type": "number", "minimum": 0`.
std::string numberSchema(const NumberRange& range, bool isInteger) {
    std::string text = isInteger ? R"("type": "integer")" : R"("type": "number")";
    const auto bound = [&](std::string_view name, bool isOpen, double value) {
        if (std::abs(value) >= kAnyNumber.hi) { return; }
        const std::string prefix = isOpen ? "exclusiveM" : "m";
        text += isInteger ? fmt::format(", \"{}{}\": {}", prefix, name, static_cast<int64_t>(value))
                          : fmt::format(", \"{}{}\": {}", prefix, name, static_cast<float>(value));
    };
    bound("inimum", range.openLo, range.lo);
    bound("aximum", range.openHi, range.hi);
    return text;
}

std::string wordSchema(const std::vector<std::string_view>& words) {
    return fmt::format("\"enum\": [\"{}\"]", fmt::join(words, "\", \""));
}

std::string colorSchema(const NumberRange& range) {
    return fmt::format("\"$ref\": \"#/definitions/{}\"", range.hi == 1.0 ? "reflectance" : "radiance");
}

/// What a file may give for a field, as the inside of a JSON object.
template <class Owner, class Member>
std::string valueSchema(const Field<Owner, Member>& field) {
    const FieldTraits& traits = field.traits;
    const auto orTexture = [](const std::string& schema) {
        return fmt::format(R"("anyOf": [{{ {} }}, {{ "$ref": "#/definitions/textureUse" }}])", schema);
    };
    if constexpr (std::is_enum_v<Member>) {
        return wordSchema(namesOf<Member>());
    } else if constexpr (std::is_same_v<Member, bool>) {
        return traits.whenTrue.empty() ? R"("type": "boolean")"
                                       : wordSchema({traits.whenTrue, traits.whenFalse});
    } else if constexpr (std::is_same_v<Member, NumberInput>) {
        return orTexture(numberSchema(traits.range, false));
    } else if constexpr (std::is_same_v<Member, ColorInput>) {
        return orTexture(colorSchema(traits.range));
    } else if constexpr (std::is_same_v<Member, Vec3>) {
        return traits.form == VectorForm::Color ? colorSchema(traits.range)
                                                : R"("$ref": "#/definitions/vec3")";
    } else if constexpr (std::is_same_v<Member, Vec2>) {
        return R"("$ref": "#/definitions/vec2")";
    } else if constexpr (std::is_same_v<Member, std::vector<Vec2>>) {
        return R"("type": "array", "minItems": 2, "items": { "$ref": "#/definitions/vec2" })";
    } else if constexpr (std::is_same_v<Member, std::vector<Vec3>>) {
        return R"("type": "array", "minItems": 4, "maxItems": 4, "items": { "$ref": "#/definitions/vec3" })";
    } else if constexpr (std::is_same_v<Member, std::string> || std::is_same_v<Member, SceneImage>) {
        return traits.words == nullptr ? R"("type": "string")" : wordSchema(traits.words());
    } else {
        if constexpr (requires(const Owner* owner) { customSchema(owner, field.key); }) {
            if (traits.custom || std::is_same_v<Owner, SceneDescription>) {
                return std::string(customSchema(static_cast<const Owner*>(nullptr), field.key));
            }
        }
        return numberSchema(traits.range, std::is_integral_v<Member>);
    }
}

using Properties = std::vector<std::pair<std::string_view, std::string>>;

class SchemaWriter {
  public:
    std::string text() const { return fmt::format("{}\n  }}\n}}\n", text_); }

    void define(std::string_view name, std::string_view help, std::string_view required,
                const Properties& properties) {
        text_ += fmt::format(",\n    \"{}\": {{\n", name);
        if (!help.empty()) { text_ += fmt::format("      \"description\": {},\n", quoteJson(help)); }
        text_ += "      \"type\": \"object\",\n";
        if (!required.empty()) { text_ += fmt::format("      \"required\": [{}],\n", required); }
        if (name == "transformStep") {
            text_ += "      \"minProperties\": 1,\n      \"maxProperties\": 1,\n";
        }
        text_ += "      \"additionalProperties\": false,\n      \"properties\": {";
        const char* separator = "\n";
        for (const auto& [key, schema] : properties) {
            text_ += fmt::format("{}        \"{}\": {{ {} }}", separator, key, schema);
            separator = ",\n";
        }
        text_ += "\n      }\n    }";
    }

    /// A definition of the fields that some kinds of a type have, and `more`.
    template <class Owner>
    void defineFields(std::string_view name, std::string_view help, uint32_t kinds,
                      const Properties& more = {}, std::string_view alsoRequired = "") {
        Properties properties;
        std::string required;
        forEachField<Owner>([&](const auto& field) {
            if (field.key.empty() || (field.traits.kinds & kinds) == 0) { return; }
            const std::string described = describeField(field.traits, true);
            std::string schema =
                field.key == "type" ? fmt::format("\"const\": \"{}\"", name) : valueSchema(field);
            if (!described.empty()) {
                schema = fmt::format("\"description\": {}, {}", quoteJson(described + "."), schema);
            }
            properties.emplace_back(field.key, std::move(schema));
            if (field.traits.required) {
                required += fmt::format("{}\"{}\"", required.empty() ? "" : ", ", field.key);
            }
        });
        properties.insert(properties.end(), more.begin(), more.end());
        if (!alsoRequired.empty()) {
            required += fmt::format("{}{}", required.empty() ? "" : ", ", alsoRequired);
        }
        define(name, help, required, properties);
    }

    /// A definition that takes one of others.
    void defineAny(std::string_view name, const std::vector<std::string_view>& others) {
        std::vector<std::string> references;
        references.reserve(others.size());
        for (const std::string_view other : others) {
            references.push_back(fmt::format(R"({{ "$ref": "#/definitions/{}" }})", other));
        }
        text_ += fmt::format(",\n    \"{}\": {{ \"oneOf\": [{}] }}", name, fmt::join(references, ", "));
    }

    template <class Owner, class Kind>
    void defineKinds(std::string_view any) {
        defineAny(any, namesOf<Kind>());
        for (const KindName<Kind>& kind : kindNames<Kind>()) {
            defineFields<Owner>(kind.name, kind.help, only(kind.kind));
        }
    }

    void defineRender() {
        Properties own;
        forEachIntegratorOptions([&](IntegratorKind kind, auto) {
            const char* key = integratorInfo(kind).key;
            own.emplace_back(key, fmt::format(R"("$ref": "#/definitions/{}")", key));
        });
        defineFields<RenderOptions>("render", "", ~0u, own);
        forEachIntegratorOptions([&](IntegratorKind kind, auto member) {
            using Options = std::remove_cvref_t<decltype(std::declval<SceneDescription>().*member)>;
            defineFields<Options>(integratorInfo(kind).key, FieldsOf<Options>::kHelp, ~0u);
        });
    }

    void defineShapes() {
        defineAny("anyObject", namesOf<ShapeKind>());
        for (const ShapeForm& form : shapeForms()) {
            const bool isMesh = form.kind == ShapeKind::Mesh;
            Properties more;
            for (const PlacementKey& key : form.keys()) {
                const std::string schema = key.form == PlacementForm::Length
                                               ? numberSchema(kPositive, false)
                                               : R"("$ref": "#/definitions/vec3")";
                const std::string help =
                    key.help[0] == '\0' ? "" : fmt::format("\"description\": {}, ", quoteJson(key.help));
                more.emplace_back(key.key, help + schema);
            }
            if (isMesh) {
                more.emplace_back("mesh",
                                  R"("description": "A mesh's name, or the mesh itself.", )"
                                  R"("anyOf": [{ "type": "string" }, { "$ref": "#/definitions/anyMesh" }])");
            }
            more.emplace_back(kHiddenKey, R"("description": "Kept in the scene and out of the picture.", )"
                                          R"("type": "boolean")");
            defineFields<Object>(form.name, form.help, only(form.kind), more,
                                 isMesh ? R"("mesh")" : R"("material")");
        }
    }

  private:
    std::string text_{kHead};
};

}  // namespace

std::string sceneSchema() {
    SchemaWriter schema;
    schema.defineFields<SceneDescription>(
        "scene", "", ~0u,
        {{"$schema", R"("type": "string")"},
         {"glint", R"("description": "Version of the format.", "const": 1)"}},
        R"("glint")");
    schema.defineFields<Camera>("camera", "", ~0u);
    schema.defineRender();
    schema.defineAny("texture", {"textureFile", "checkerboard"});
    schema.defineFields<Texture>("textureFile", "", FieldsOf<Texture>::kInFile);
    schema.defineFields<Texture>("checkerboard",
                                 "Squares of two colours, two along each unit of u and v; the nearest texel "
                                 "unless filter says otherwise.",
                                 FieldsOf<Texture>::kGenerated,
                                 {{"generator", R"("const": "checkerboard")"},
                                  {"even", R"("$ref": "#/definitions/radiance")"},
                                  {"odd", R"("$ref": "#/definitions/radiance")"}},
                                 R"("generator")");
    schema.defineKinds<Material, MaterialKind>("anyMaterial");
    schema.defineAny("anyMesh", {"meshFile", "meshGenerator", "meshInline"});
    schema.defineFields<FileSource>("meshFile", "", ~0u);
    schema.defineFields<MeshGenerator>("meshGenerator", "", ~0u);
    schema.defineShapes();
    schema.defineKinds<Light, LightKind>("anyLight");
    schema.defineFields<Environment>(
        "environment", "Light from infinitely far away, and the background. Black if left out.", ~0u);
    schema.defineFields<SkySource>("sky", "A generated gradient with a sun.", ~0u,
                                   {{"generator", R"("const": "sky")"}}, R"("generator")");
    for (const JsonForm& form : jsonForms()) {
        Properties properties;
        for (const JsonKey& key : form.keys) {
            properties.emplace_back(key.key, std::string(key.schema));
        }
        schema.define(form.name, form.help, form.required, properties);
    }
    return schema.text();
}

}  // namespace glint
