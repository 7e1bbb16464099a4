#include "engine/render/checkpoint_scene.h"

#include <filesystem>
#include <utility>

#include "engine/io/scene_json.h"
#include "engine/io/scene_names.h"

namespace glint {
namespace {

constexpr const char* kTag = "SCNE";

}  // namespace

std::string absolutePath(const std::string& path) {
    std::error_code problem;
    const std::filesystem::path absolute = std::filesystem::absolute(path, problem);
    return problem ? path : absolute.lexically_normal().string();
}

void writeCheckpointScene(const SceneDescription& scene, CheckpointWriter* file) {
    const Result<std::string> json = writeSceneJson(scene, scene.path);
    if (!json) { return; }
    file->section(kTag, [&](ByteWriter* out) {
        out->writeText(absolutePath(scene.path));
        out->writeText(*json);
    });
}

std::string checkpointScenePath(const CheckpointSections& sections) {
    const auto section = sections.find(kTag);
    return section == sections.end() ? "" : ByteReader(section->second).readText();
}

Result<SceneDescription> readCheckpointScene(const CheckpointSections& sections, const std::string& path) {
    const auto section = sections.find(kTag);
    if (section == sections.end()) { return checkpointError(path, "does not hold the scene it is of"); }
    ByteReader in(section->second);
    TextSource source;
    source.path = in.readText();
    source.text = in.readText();
    if (in.failed()) { return checkpointError(path, "is damaged: its scene is cut off"); }
    Result<SceneDescription> scene = readSceneJson(std::move(source), {});
    if (scene) { makeNamesText(&*scene); }
    return scene;
}

}  // namespace glint
