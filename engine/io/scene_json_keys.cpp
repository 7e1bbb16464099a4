#include "engine/io/scene_json_keys.h"

#include "engine/base/check.h"

namespace glint {

std::span<const JsonForm> jsonForms() {
    constexpr std::string_view kVec3 = R"("$ref": "#/definitions/vec3")";
    constexpr std::string_view kVec3Array = R"("type": "array", "items": { "$ref": "#/definitions/vec3" })";
    constexpr std::string_view kNumber = R"("type": "number")";
    static const std::vector<JsonForm> kForms{
        {"textureUse",
         "",
         R"("texture")",
         {{"texture", R"("description": "A texture's name, or the texture itself.", )"
                      R"("anyOf": [{ "type": "string" }, { "$ref": "#/definitions/texture" }])"},
          {"fallback", R"("description": "Used where the file is missing and --allow-missing is given.", )"
                       R"("$ref": "#/definitions/radiance")"}}},
        {"meshInline",
         "",
         R"("positions", "triangles")",
         {{"positions", kVec3Array},
          {"triangles", R"("description": "[a, b, c]: positions from 0, counter-clockwise from the front.", )"
                        R"("type": "array", "minItems": 1, "items": { "type": "array", "minItems": 3, )"
                        R"("maxItems": 3, "items": { "type": "integer", "minimum": 0 } })"},
          {"normals",
           R"("description": "One for each position. Triangles wound against theirs are turned over: )"
           R"(normals decide which side is the front.", )"
           R"("type": "array", "items": { "$ref": "#/definitions/vec3" })"},
          {"uvs", R"("type": "array", "items": { "$ref": "#/definitions/vec2" })"},
          {"colors", kVec3Array},
          {"tangents",
           R"("description": "One for each position, for normal maps and anisotropy: x, y, z along u, and )"
           R"(w, 1 or -1: v runs along cross(normal, tangent) w. Zeros: as the uvs run.", )"
           R"("type": "array", "items": { "type": "array", "minItems": 4, "maxItems": 4, )"
           R"("items": { "type": "number" } })"}}},
        {"transformStep",
         "One of these.",
         "",
         {{"translate", kVec3},
          {"scale", R"("anyOf": [{ "type": "number" }, { "$ref": "#/definitions/vec3" }])"},
          {"rotate", R"("$ref": "#/definitions/rotation")"},
          {"rotateXDeg", kNumber},
          {"rotateYDeg", kNumber},
          {"rotateZDeg", kNumber},
          {"matrix", R"("description": "Three rows of four numbers, one after the other; the fourth is the )"
                     R"(translation.", "type": "array", "minItems": 12, "maxItems": 12, )"
                     R"("items": { "type": "number" })"}}},
        {"rotation", "Right-handed.", R"("axis", "angleDeg")", {{"axis", kVec3}, {"angleDeg", kNumber}}},
        {"environmentFile",
         "",
         R"("file")",
         {{"file", R"("description": "HDR or EXR; relative to the scene's folder.", "type": "string")"}}}};
    return kForms;
}

std::vector<std::string_view> formKeys(std::string_view name) {
    std::vector<std::string_view> keys;
    for (const JsonForm& form : jsonForms()) {
        for (const JsonKey& key : form.keys) {
            if (form.name == name) { keys.push_back(key.key); }
        }
    }
    GLINT_CHECK(!keys.empty());
    return keys;
}

}  // namespace glint
