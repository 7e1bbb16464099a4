#include "engine/render/checkpoint_scene.h"

#include <filesystem>
#include <utility>

#include "engine/io/scene_json.h"
#include "engine/io/scene_loader.h"
#include "engine/io/scene_names.h"

namespace glint {
namespace {

constexpr const char* kTag = "SCNE";
constexpr const char* kReadTag = "READ";
constexpr uint32_t kMaxParameters = 10'000;

}  // namespace

std::string absolutePath(const std::string& path) {
    std::error_code problem;
    const std::filesystem::path absolute = std::filesystem::absolute(path, problem);
    return problem ? path : absolute.lexically_normal().string();
}

void writeCheckpointScene(const SceneDescription& scene, CheckpointWriter* file) {
    if (!scene.path.empty()) {
        file->section(kReadTag, [&](ByteWriter* out) {
            out->writeText(absolutePath(scene.path));
            out->write(static_cast<uint8_t>(scene.readWith.allowMissing));
            out->write(static_cast<uint8_t>(scene.readWith.noStudio));
            out->write(static_cast<uint32_t>(scene.readWith.parameters.size()));
            for (const auto& [name, value] : scene.readWith.parameters) {
                out->writeText(name);
                out->writeText(value);
            }
        });
    }
    const Result<std::string> json = writeSceneJson(scene, scene.path);
    if (!json) { return; }
    file->section(kTag, [&](ByteWriter* out) {
        out->writeText(absolutePath(scene.path));
        out->writeText(*json);
    });
}

std::string checkpointScenePath(const CheckpointSections& sections) {
    for (const char* tag : {kTag, kReadTag}) {
        if (const auto section = sections.find(tag); section != sections.end()) {
            return ByteReader(section->second).readText();
        }
    }
    return "";
}

ReadingOptions checkpointReadingOptions(const CheckpointSections& sections) {
    const auto section = sections.find(kReadTag);
    if (section == sections.end()) { return {}; }
    ByteReader in(section->second);
    in.readText();
    ReadingOptions options;
    options.allowMissing = in.read<uint8_t>() != 0;
    options.noStudio = in.read<uint8_t>() != 0;
    const auto count = in.read<uint32_t>();
    for (uint32_t i = 0; i < count && i < kMaxParameters && !in.failed(); ++i) {
        std::string name = in.readText();
        options.parameters.emplace_back(std::move(name), in.readText());
    }
    return in.failed() ? ReadingOptions() : options;
}

Result<SceneDescription> readCheckpointScene(const CheckpointSections& sections, const std::string& path) {
    const auto section = sections.find(kTag);
    if (section == sections.end()) {
        const std::string file = checkpointScenePath(sections);
        if (file.empty()) { return checkpointError(path, "does not hold the scene it is of"); }
        return loadScene(file, loadOptionsOf(checkpointReadingOptions(sections)));
    }
    ByteReader in(section->second);
    TextSource source;
    source.path = in.readText();
    source.text = in.readText();
    if (in.failed()) { return checkpointError(path, "is damaged: its scene is cut off"); }
    Result<SceneDescription> scene = readSceneJson(std::move(source), {});
    if (scene) {
        makeNamesText(&*scene);
        scene->readWith = checkpointReadingOptions(sections);
    }
    return scene;
}

}  // namespace glint
