// 6.837-style scenes: camera, background, lights, and what the whole file decides.
#include "engine/io/scene_text.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "engine/io/bump_scale.h"
#include "engine/io/scene_text_reader.h"
#include "engine/scene/object_box.h"

namespace glint {
namespace {

/// Of the angle between view and up: less says nothing about which way is up (camera_builder.cpp).
constexpr float kLeastSine = 1e-6f;

}  // namespace

SceneTextReader::SceneTextReader(TextSource source, const LoadOptions& options)
    : tokens_(std::move(source)), options_(options), assets_(tokens_.source().path, options.counts) {
    scene_.path = tokens_.source().path;
    scene_.title = scene_.path.substr(scene_.path.find_last_of('/') + 1);
    scene_.environment.color = Vec3(0.5f);
}

Result<SceneDescription> SceneTextReader::read() {
    readBlocks();
    if (!tokens_.failed()) { finish(); }
    if (tokens_.failed()) { return tokens_.error(); }
    if (missingMesh_ && scene_.objects.empty() && !options_.allowMissing) { return *missingMesh_; }
    return std::move(scene_);
}

void SceneTextReader::readBlocks() {
    while (!tokens_.atEnd()) {
        const std::string word(tokens_.peek().text);
        if (word != "Group" && std::find(seenBlocks_.begin(), seenBlocks_.end(), word) != seenBlocks_.end()) {
            tokens_.fail(tokens_.peek(), fmt::format("a second '{}' block; expected one", word));
            return;
        }
        seenBlocks_.push_back(word);
        readBlock(word);
    }
}

void SceneTextReader::readBlock(std::string_view word) {
    constexpr std::string_view kBlocks[] = {"PerspectiveCamera", "Background", "Lights",
                                            "DiskLights",        "Materials",  "Group"};
    if (word == "PerspectiveCamera") {
        readCamera();
    } else if (word == "Background") {
        readBackground();
    } else if (word == "Lights") {
        readLights();
    } else if (word == "DiskLights") {
        readDiskLights();
    } else if (word == "Materials") {
        readMaterials();
    } else if (word == "Group") {
        readGroup(Affine(), 0);
    } else {
        tokens_.failUnknown("a scene", kBlocks);
    }
}

void SceneTextReader::readCamera() {
    constexpr std::string_view kFields[] = {"center", "direction", "up",          "angle",
                                            "width",  "height",    "focalLength", "aperture"};
    const TextToken at = tokens_.take();
    tokens_.expect("{", "PerspectiveCamera");
    Vec3 direction(0.0f, 0.0f, -1.0f);
    Vec3 up(0.0f, 1.0f, 0.0f);
    float angleDeg = 45.0f;
    float focalLength = 1.0f;
    float halfAperture = 0.0f;
    while (!tokens_.accept("}") && !tokens_.failed()) {
        if (tokens_.accept("center")) {
            scene_.camera.position = tokens_.vec3("center");
        } else if (tokens_.accept("direction")) {
            direction = tokens_.direction("direction");
        } else if (tokens_.accept("up")) {
            up = tokens_.direction("up");
        } else if (tokens_.accept("angle")) {
            angleDeg = tokens_.number("angle", 0.001f, 179.9f, "an angle between 0 and 180 degrees");
        } else if (tokens_.accept("width")) {
            scene_.resolution.width = tokens_.integer("width", 1, 16384);
        } else if (tokens_.accept("height")) {
            scene_.resolution.height = tokens_.integer("height", 1, 16384);
        } else if (tokens_.accept("focalLength")) {
            focalLength = tokens_.number("focalLength", 1e-30f, 1e30f, "a distance > 0");
        } else if (tokens_.accept("aperture")) {
            halfAperture = tokens_.number("aperture", 0.0f, 1e30f, "half a side of the lens, >= 0");
        } else {
            tokens_.failUnknown("PerspectiveCamera", kFields);
        }
    }
    if (!tokens_.failed()) { placeCamera(at, direction, up, angleDeg, focalLength, halfAperture); }
}

void SceneTextReader::placeCamera(const TextToken& at, const Vec3& direction, const Vec3& up, float angleDeg,
                                  float focalLength, float halfAperture) {
    Camera& camera = scene_.camera;
    const Vec3 forward = glm::normalize(direction);
    camera.target = camera.position + focalLength * forward;
    if (camera.target == camera.position) {
        camera.target = camera.position + maxComponent(absVec(camera.position)) * forward;
    }
    camera.up = up;
    // The original does not normalise its image axes: both have the length of `direction x up`.
    float narrowing = glm::length(glm::cross(forward, up));
    if (narrowing <= kLeastSine * glm::length(up)) {
        narrowing = 1.0f;
        scene_.notes.push_back(tokens_.source().warning(
            at.offset, "the camera looks along 'up': another axis is up, and the angle is not narrowed"));
    }
    const float halfAngleRad = 0.5f * angleDeg * (kPi / 180.0f);
    camera.verticalFovDeg =
        narrowing == 1.0f ? angleDeg : 2.0f * std::atan(narrowing * std::tan(halfAngleRad)) * (180.0f / kPi);
    camera.focalDistance = focalLength;
    if (halfAperture > 0.0f) {
        camera.apertureDiameter = 2.0f * std::sqrt(2.0f) * halfAperture;
        camera.apertureBlades = 4;
        camera.bladeRotationDeg = 45.0f;
    }
}

void SceneTextReader::readBackground() {
    constexpr std::string_view kFields[] = {"color", "ambientLight"};
    tokens_.take();
    tokens_.expect("{", "Background");
    while (!tokens_.accept("}") && !tokens_.failed()) {
        if (tokens_.accept("color")) {
            scene_.environment.color = tokens_.color("the background's color");
        } else if (tokens_.accept("ambientLight")) {
            scene_.rayCast.ambient = tokens_.color("ambientLight");
        } else {
            tokens_.failUnknown("Background", kFields);
        }
    }
}

void SceneTextReader::readLights() {
    constexpr std::string_view kKinds[] = {"PointLight", "DirectionalLight"};
    tokens_.take();
    tokens_.expect("{", "Lights");
    tokens_.expect("numLights", "'Lights {'");
    const int count = tokens_.integer("numLights", 0, 1'000'000);
    for (int i = 0; i < count && !tokens_.failed(); ++i) {
        Light light;
        light.name = fmt::format("light {}", i + 1);
        if (tokens_.peek().text != "PointLight" && tokens_.peek().text != "DirectionalLight") {
            tokens_.failUnknown(fmt::format("Lights ({} of {} read)", i, count), kKinds);
            return;
        }
        light.kind = tokens_.take().text == "PointLight" ? LightKind::Point : LightKind::Directional;
        const bool isPoint = light.kind == LightKind::Point;
        tokens_.expect("{", isPoint ? "PointLight" : "DirectionalLight");
        while (!tokens_.accept("}") && !tokens_.failed()) {
            const std::string_view placed = isPoint ? "position" : "direction";
            const std::string_view fields[] = {placed, "color"};
            if (tokens_.accept("color")) {
                light.color = tokens_.color("the light's color");
            } else if (isPoint && tokens_.accept("position")) {
                light.position = tokens_.vec3("position");
            } else if (!isPoint && tokens_.accept("direction")) {
                light.direction = tokens_.direction("direction");
            } else {
                tokens_.failUnknown("a light", fields);
            }
        }
        scene_.lights.push_back(std::move(light));
    }
    tokens_.expect("}", fmt::format("{} lights", count));
}

void SceneTextReader::readDiskLights() {
    constexpr std::string_view kFields[] = {"position", "direction", "color", "radius"};
    const TextToken at = tokens_.take();
    tokens_.expect("{", "DiskLights");
    tokens_.expect("numDiskLights", "'DiskLights {'");
    const int count = tokens_.integer("numDiskLights", 0, 1'000'000);
    for (int i = 0; i < count && !tokens_.failed(); ++i) {
        tokens_.expect("DiskLight", fmt::format("{} of {} DiskLights", i, count));
        tokens_.expect("{", "DiskLight");
        while (!tokens_.accept("}") && !tokens_.failed()) {
            if (tokens_.accept("radius")) {
                tokens_.number("radius", 0.0f, 1e30f, "a radius >= 0");
            } else if (tokens_.accept("position") || tokens_.accept("direction") || tokens_.accept("color")) {
                tokens_.vec3("a DiskLight");
            } else {
                tokens_.failUnknown("a DiskLight", kFields);
            }
        }
    }
    tokens_.expect("}", fmt::format("{} DiskLights", count));
    if (count > 0) { remark(at, "DiskLights are left out, as the original's path tracer does", ""); }
}

void SceneTextReader::finish() {
    if (scene_.materials.empty() && !scene_.objects.empty()) {
        Material white;
        white.name = "white";
        white.color.value = Vec3(1.0f);
        scene_.materials.push_back(std::move(white));
    }
    readTextures();
    scaleMeshBumps();
    const bool anyEmits =
        std::any_of(scene_.objects.begin(), scene_.objects.end(), [&](const Object& object) {
            return scene_.materials[static_cast<size_t>(object.material)].emissive();
        });
    if (!scene_.lights.empty()) { useLights(anyEmits); }
    const std::vector<std::string> lines = remarks_.lines();
    scene_.warnings.insert(scene_.warnings.end(), lines.begin(), lines.end());
}

void SceneTextReader::scaleMeshBumps() {
    std::map<int, ImageWidth> widths;
    for (const Object& object : scene_.objects) {
        if (object.shape != ShapeKind::Mesh ||
            scene_.materials[static_cast<size_t>(object.material)].bump.texture < 0) {
            continue;
        }
        const Mesh& mesh = scene_.meshes[static_cast<size_t>(object.mesh)];
        if (mesh.data) {
            widths[object.material].add(*mesh.data, std::cbrt(std::fabs(object.objectToWorld.determinant())));
        }
    }
    for (const auto& [index, width] : widths) {
        Material& material = scene_.materials[static_cast<size_t>(index)];
        material.bumpHeight = width.bumpHeight(scene_.textures[static_cast<size_t>(material.bump.texture)]);
    }
}

void SceneTextReader::useLights(bool onlyToCastRays) {
    const Vec3 center = sceneCenter();
    scene_.rayCast.shadows = scene_.rayCast.falloff = false;  // As the original casts rays.
    for (Light& light : scene_.lights) {
        light.strength = kPi;  // Phong's diffuse term lacks Lambert's 1 / pi.
        if (light.kind == LightKind::Point) { light.strength *= lengthSquared(light.position - center); }
        light.onlyRayCast = onlyToCastRays;
    }
    if (onlyToCastRays) { return; }
    scene_.environment.seenOnly = true;
    scene_.notes.push_back(fmt::format(
        "{}: no material emits, so the Lights block shines and the background lights nothing; point "
        "lights fall off with distance and are as bright as written at the scene's middle",
        scene_.path));
}

Vec3 SceneTextReader::sceneCenter() const {
    const Bounds bounds = sceneBounds(scene_);
    return bounds.empty() ? scene_.camera.target : bounds.center();
}

void SceneTextReader::remark(const TextToken& at, std::string_view kind, std::string_view detail) {
    const auto place = [&] {
        return fmt::format("{}:{}", scene_.path, tokens_.source().place(at.offset).line);
    };
    if (!tokens_.failed()) { remarks_.add(kind, place, detail); }
}

std::string SceneTextReader::locate(const std::string& path) const {
    const std::string above = "../" + path;
    const bool isAbove =
        !fileExists(resolvePath(path, scene_.path)) && fileExists(resolvePath(above, scene_.path));
    return isAbove ? above : path;
}

Result<SceneDescription> readSceneText(TextSource source, const LoadOptions& options) {
    return SceneTextReader(std::move(source), options).read();
}

}  // namespace glint
