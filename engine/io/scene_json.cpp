// Glint JSON: the root object, camera, resolution and render options.
#include "engine/io/scene_json.h"

#include <fmt/format.h>

#include "engine/base/nearest_name.h"
#include "engine/io/scene_json_keys.h"
#include "engine/io/scene_json_reader.h"

namespace glint {
namespace {

constexpr int64_t kMaxSide = 32768;
constexpr int64_t kMaxPixels = int64_t{1} << 28;
constexpr int64_t kMaxPhotonsPerPass = int64_t{1} << 30;
constexpr int64_t kMaxMemoryBudgetMiB = int64_t{1} << 22;
constexpr NumberRange kAlphaRange{
    .lo = 0.0f, .hi = 1.0f, .openLo = true, .openHi = true, .expected = "a number between 0 and 1"};
constexpr NumberRange kRadiusRange{
    .lo = 0.0f, .hi = 1e18f, .expected = "a radius in metres, or 0 for an automatic one"};
constexpr NumberRange kFootprintRange{
    .lo = 0.0f, .hi = 1e6f, .openLo = true, .expected = "a number above 0 and up to 1e6"};

}  // namespace

SceneJsonReader::SceneJsonReader(std::shared_ptr<const JsonDocument> document, const LoadOptions& options)
    : document_(std::move(document)), options_(options), assets_(document_->source.path, options.counts) {
    scene_.path = document_->source.path;
}

Result<SceneDescription> SceneJsonReader::read() {
    const JsonValue root(document_.get());
    readRoot(fieldsOf(root, "the scene", "scene"));
    if (errors_.failed()) { return errors_.error(); }
    return std::move(scene_);
}

void SceneJsonReader::readRoot(const JsonFields& root) {
    int version = 1;
    root.require("glint");
    root.integer("glint", 1, 1, &version);
    std::string schema;
    root.string("$schema", &schema);
    root.string("title", &scene_.title);
    root.string("description", &scene_.description);
    readResolution(root.find("resolution"));
    readCamera(root.find("camera"));
    readRender(root.find("render"));
    readTextures(root.find("textures"));
    readMaterials(root.find("materials"));
    readMeshes(root.find("meshes"));
    readObjects(root.find("objects"));
    readLights(root.find("lights"));
    readEnvironment(root.find("environment"));
    readAssets();
}

void SceneJsonReader::readResolution(const JsonValue& value) {
    if (!value.present() || !expectType(errors_, value, "resolution", JsonType::Array)) { return; }
    if (value.size() != 2) {
        errors_.add(value, "\"resolution\" needs two numbers: [width, height] in pixels");
        return;
    }
    int64_t size[2] = {};
    forEachItem(errors_, value, [&](const JsonValue& item, size_t i) {
        readInteger(errors_, item, i == 0 ? "width" : "height", 1, kMaxSide, &size[i]);
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
    const JsonFields fields = fieldsOf(value, "camera", "camera");
    Camera& camera = scene_.camera;
    fields.vec3("position", &camera.position);
    fields.vec3("target", &camera.target);
    fields.direction("up", &camera.up);
    const Vec3 view = camera.target - camera.position;
    if (isZero(view)) {
        errors_.add(value,
                    "the camera's \"position\" and \"target\" are the same point, so it looks nowhere");
    } else if (isZero(glm::cross(glm::normalize(view), glm::normalize(camera.up)))) {
        errors_.add(value,
                    "the camera looks along \"up\"; expected an \"up\" that is not parallel to the view");
    }
    camera.focalDistance = glm::length(view);
    fields.number("verticalFovDeg",
                  {.lo = 0.0f,
                   .hi = 180.0f,
                   .openLo = true,
                   .openHi = true,
                   .expected = "an angle between 0 and 180 degrees"},
                  &camera.verticalFovDeg);
    fields.number("horizontalScale", kPositive, &camera.horizontalScale);
    fields.number("apertureDiameter", kNotNegative, &camera.apertureDiameter);
    fields.number("focalDistance", kPositive, &camera.focalDistance);
    fields.integer("apertureBlades", 0, 64, &camera.apertureBlades);
    if (camera.apertureBlades == 1 || camera.apertureBlades == 2) {
        errors_.add(fields.find("apertureBlades"),
                    "\"apertureBlades\" is less than 3; expected 0 (round) or 3 to 64");
    }
    fields.number("bladeRotationDeg", kAnyNumber, &camera.bladeRotationDeg);
}

void SceneJsonReader::readRender(const JsonValue& value) {
    if (!value.present()) { return; }
    const JsonFields fields = fieldsOf(value, "render", "render");
    RenderOptions& options = scene_.options;
    constexpr std::pair<std::string_view, IntegratorKind> kIntegrators[] = {
        {"path", IntegratorKind::PathTracing}, {"sppm", IntegratorKind::Sppm}};
    constexpr std::pair<std::string_view, FilterKind> kFilters[] = {
        {"box", FilterKind::Box},
        {"gaussian", FilterKind::Gaussian},
        {"blackman-harris", FilterKind::BlackmanHarris}};
    constexpr std::pair<std::string_view, SamplerKind> kSamplers[] = {
        {"sobol", SamplerKind::Sobol}, {"independent", SamplerKind::Independent}};
    fields.choice("integrator", kIntegrators, &options.integrator);
    fields.integer("maxDepth", 0, 1 << 16, &options.maxDepth);
    fields.integer("rouletteStartDepth", 0, 1 << 16, &options.rouletteStartDepth);
    fields.choice("filter", kFilters, &options.filter);
    if (options.filter == FilterKind::Box) { options.filterRadius = 0.5f; }
    fields.number(
        "filterRadiusPixels",
        {.lo = 0.0f, .hi = 16.0f, .openLo = true, .expected = "a radius above 0 and up to 16 pixels"},
        &options.filterRadius);
    fields.choice("sampler", kSamplers, &options.sampler);
    fields.integer("seed", 0, 0xFFFFFFFFll, &options.seed);
    fields.number("fireflyClamp", kNotNegative, &options.fireflyClamp);
    readSppm(fields.find("sppm"));
}

void SceneJsonReader::readSppm(const JsonValue& value) {
    if (!value.present()) { return; }
    const JsonFields fields = fieldsOf(value, "sppm", "sppm");
    SppmOptions& sppm = scene_.sppm;
    constexpr std::pair<std::string_view, bool> kDirectLights[] = {{"sampled", true}, {"photons", false}};
    constexpr std::pair<std::string_view, PhotonLookupKind> kLookups[] = {{"grid", PhotonLookupKind::Grid},
                                                                          {"tree", PhotonLookupKind::Tree}};
    fields.integer("photonsPerPass", 1, kMaxPhotonsPerPass, &sppm.photonsPerPass);
    fields.number("alpha", kAlphaRange, &sppm.alpha);
    fields.number("radius", kRadiusRange, &sppm.radiusWorld);
    fields.number("radiusFootprints", kFootprintRange, &sppm.radiusFootprints);
    fields.number("storeRoughness", kUnitInterval, &sppm.storeRoughness);
    fields.choice("directLight", kDirectLights, &sppm.sampleDirectLight);
    fields.choice("lookup", kLookups, &sppm.lookup);
    fields.integer("memoryBudgetMiB", 0, kMaxMemoryBudgetMiB, &sppm.memoryBudgetMiB);
}

JsonFields SceneJsonReader::fieldsOf(const JsonValue& value, std::string_view what, std::string_view kind) {
    return JsonFields(errors_, value, what, sceneJsonKeys(kind));
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

Result<SceneDescription> readSceneJson(TextSource source, const LoadOptions& options) {
    auto document = parseJson(std::move(source));
    if (!document) { return document.error(); }
    return SceneJsonReader(std::move(*document), options).read();
}

}  // namespace glint
