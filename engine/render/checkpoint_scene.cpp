#include "engine/render/checkpoint_scene.h"

#include <filesystem>
#include <memory>
#include <utility>

#include "engine/io/embedded_files.h"
#include "engine/io/scene_json.h"
#include "engine/io/scene_loader.h"
#include "engine/io/scene_names.h"

namespace glint {
namespace {

constexpr const char* kTag = "SCNE";
constexpr const char* kReadTag = "READ";
constexpr const char* kEmbeddedTag = "EMBD";
constexpr uint32_t kMaxParameters = 10'000;

/// Error: the section is cut off.
Result<EmbeddedByPath> readEmbedded(const CheckpointSections& sections, const std::string& path) {
    EmbeddedByPath files;
    const auto section = sections.find(kEmbeddedTag);
    if (section == sections.end()) { return files; }
    ByteReader in(section->second);
    const auto count = in.read<uint32_t>();
    for (uint32_t i = 0; i < count && !in.failed(); ++i) {
        const std::string at = in.readText();
        EmbeddedFile& file = files[at];
        file.name = in.readText();
        file.bytes = std::make_shared<const std::string>(in.readText());
    }
    if (in.failed()) { return checkpointError(path, "is damaged: the files of its scene are cut off"); }
    return files;
}

}  // namespace

std::string absolutePath(const std::string& path) {
    std::error_code problem;
    const std::filesystem::path absolute = std::filesystem::absolute(path, problem);
    return problem ? path : absolute.lexically_normal().string();
}

size_t embeddedBytes(const SceneDescription& scene) {
    SceneDescription named = scene;
    size_t bytes = 0;
    for (const auto& [path, file] : nameEmbeddedFiles(&named)) {
        bytes += file.bytes->size();
    }
    return bytes;
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
    SceneDescription named = scene;
    const EmbeddedByPath files = nameEmbeddedFiles(&named);
    const Result<std::string> json = writeSceneJson(named, scene.path);
    if (!json) { return; }
    if (!files.empty()) {
        file->section(kEmbeddedTag, [&](ByteWriter* out) {
            out->write(static_cast<uint32_t>(files.size()));
            for (const auto& [path, embedded] : files) {
                out->writeText(path);
                out->writeText(embedded.name);
                out->writeText(*embedded.bytes);
            }
        });
    }
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
    const Result<EmbeddedByPath> files = readEmbedded(sections, path);
    if (!files) { return files.error(); }
    Result<SceneDescription> scene = readSceneJson(std::move(source), {}, *files);
    if (scene) {
        makeNamesText(&*scene);
        scene->readWith = checkpointReadingOptions(sections);
    }
    return scene;
}

}  // namespace glint
