// Glint JSON: the root object, camera, resolution and render options.
#include "engine/io/scene_json.h"

#include <fmt/format.h>

#include "engine/base/nearest_name.h"
#include "engine/io/scene_json_fields.h"

namespace glint {
namespace {

constexpr int64_t kMaxPixels = int64_t{1} << 28;

}  // namespace

SceneJsonReader::SceneJsonReader(std::shared_ptr<const JsonDocument> document, const LoadOptions& options)
    : document_(std::move(document)), options_(options), assets_(document_->source.path, options.counts) {
    scene_.path = document_->source.path;
}

Result<SceneDescription> SceneJsonReader::read(const EmbeddedByPath& embedded) {
    const JsonValue root(document_.get());
    std::vector<std::string_view> keys = fieldKeys<SceneDescription>();
    keys.insert(keys.begin(), {"$schema", "glint"});
    readRoot(fieldsOf(root, "the scene", std::move(keys)));
    restoreEmbeddedFiles(embedded, &scene_);
    readAssets();
    if (errors_.failed()) { return errors_.error(); }
    return std::move(scene_);
}

void SceneJsonReader::readRoot(const JsonFields& root) {
    int version = 1;
    root.require("glint");
    root.integer("glint", {.lo = 1, .hi = 1}, &version);
    std::string schema;
    root.string("$schema", &schema);
    readFields(root, ~0u, &scene_);
    readResolution(root.find("resolution"));
    readCamera(root.find("camera"));
    readRender(root.find("render"));
    readTextures(root.find("textures"));
    readMaterials(root.find("materials"));
    readMeshes(root.find("meshes"));
    readObjects(root.find("objects"));
    readLights(root.find("lights"));
    readEnvironment(root.find("environment"));
}

void SceneJsonReader::readResolution(const JsonValue& value) {
    if (!value.present() || !expectType(errors_, value, "resolution", JsonType::Array)) { return; }
    if (value.size() != 2) {
        errors_.add(value, "\"resolution\" needs two numbers: [width, height] in pixels");
        return;
    }
    int64_t size[2] = {};
    JsonValue item = value.first();
    int i = 0;
    forEachField<Resolution>([&](const auto& field) {
        if (errors_.failed()) { return; }
        readInteger(errors_, item, field.key, field.traits.range, &size[i++]);
        item = value.next(item);
    });
    if (size[0] * size[1] > kMaxPixels) {
        errors_.add(value, fmt::format("{} x {} pixels are too many; expected at most {} in all", size[0],
                                       size[1], kMaxPixels));
        return;
    }
    scene_.resolution = {static_cast<int>(size[0]), static_cast<int>(size[1])};
}

void SceneJsonReader::readCamera(const JsonValue& value) {
    if (!value.present()) { return; }
    Camera& camera = scene_.camera;
    readFields(fieldsOf(value, "camera", fieldKeys<Camera>()), ~0u, &camera);
    const Vec3 view = camera.target - camera.position;
    if (isZero(view)) {
        errors_.add(value,
                    "the camera's \"position\" and \"target\" are the same point, so it looks nowhere");
    }
}

void SceneJsonReader::readRender(const JsonValue& value) {
    if (!value.present()) { return; }
    std::vector<std::string_view> keys = fieldKeys<RenderOptions>();
    forEachIntegratorOptions([&](IntegratorKind kind, auto) { keys.emplace_back(integratorInfo(kind).key); });
    const JsonFields fields = fieldsOf(value, "render", keys);
    readFields(fields, ~0u, &scene_.options);
    forEachIntegratorOptions([&](IntegratorKind kind, auto member) {
        const char* key = integratorInfo(kind).key;
        auto& options = scene_.*member;
        if (const JsonValue own = fields.find(key); own.present()) {
            readFields(fieldsOf(own, key, fieldKeys<std::remove_reference_t<decltype(options)>>()), ~0u,
                       &options);
        }
    });
}

int SceneJsonReader::typeOf(const JsonValue& value, std::string_view what,
                            std::span<const std::string_view> kinds) {
    if (errors_.failed() || !expectType(errors_, value, what, JsonType::Object)) { return -1; }
    JsonValue type;
    forEachMember(errors_, value, [&](const std::string& key, const JsonValue& member) {
        type = key == "type" ? member : type;
    });
    std::string name;
    if (!type.present()) {
        errors_.add(value, fmt::format("{} has no \"type\"; expected {}", what, joinNames(kinds)));
        return -1;
    }
    if (!readString(errors_, type, "type", &name)) { return -1; }
    for (size_t i = 0; i < kinds.size(); ++i) {
        if (kinds[i] == name) { return static_cast<int>(i); }
    }
    errors_.add(type, fmt::format("unknown type \"{}\" of {}{}; expected {}", name.substr(0, 60), what,
                                  didYouMean(name, kinds), joinNames(kinds)));
    return -1;
}

int SceneJsonReader::findName(const std::map<std::string, int>& names, const JsonValue& value,
                              std::string_view what) {
    std::string name;
    if (!readString(errors_, value, what, &name)) { return -1; }
    if (const auto found = names.find(name); found != names.end()) { return found->second; }
    std::vector<std::string_view> known;
    known.reserve(names.size());
    for (const auto& entry : names) {
        known.push_back(entry.first);
    }
    const std::string list = std::string(what) + (what == "mesh" ? "es" : "s");
    const std::string choices = known.empty() ? fmt::format("the scene has no \"{}\"", list)
                                : known.size() > 12
                                    ? fmt::format("expected one of the {} in \"{}\"", known.size(), list)
                                    : "expected " + joinNames(known);
    errors_.add(value, fmt::format("no {} is called \"{}\"{}; {}", what, name.substr(0, 60),
                                   didYouMean(name, known), choices));
    return -1;
}

Result<SceneDescription> readSceneJson(TextSource source, const LoadOptions& options,
                                       const EmbeddedByPath& embedded) {
    auto document = parseJson(std::move(source));
    if (!document) { return document.error(); }
    return SceneJsonReader(std::move(*document), options).read(embedded);
}

}  // namespace glint
