#include "viewer/model/example_scenes.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

#include <nlohmann/json.hpp>

#include "engine/io/atomic_file.h"
#include "engine/io/image_io.h"

namespace glint {
namespace {

namespace fs = std::filesystem;
constexpr const char* kThumbnails = "../assets/scenes";
constexpr const char* kSchema = "glint.schema.json";  // lies in the folder, and is no scene

std::string titleOf(const fs::path& file) {
    const auto text = readFile(file.string());
    const auto json = text ? nlohmann::json::parse(*text, nullptr, false, true) : nlohmann::json();
    const bool hasTitle = json.is_object() && json.contains("title") && json["title"].is_string();
    return hasTitle ? json["title"].get<std::string>() : file.stem().string();
}

Thumbnail thumbnailOf(const Image8& image) {
    Thumbnail out{image.width, image.height, {}, newThumbnailId()};
    for (size_t i = 0; i + 2 < image.rgb.size(); i += 3) {
        out.rgba.insert(out.rgba.end(), {image.rgb[i], image.rgb[i + 1], image.rgb[i + 2], 255});
    }
    return out;
}

}  // namespace

std::optional<std::string> examplesFolder() {
    std::error_code problem;
    const fs::path program = fs::read_symlink("/proc/self/exe", problem).parent_path();
    for (const char* place : {"../share/glint/scenes", "../../scenes"}) {
        const fs::path folder = (program / place).lexically_normal();
        if (fs::exists(folder / kSchema, problem)) { return folder.string(); }
    }
    return std::nullopt;
}

std::vector<ExampleScene> listExamples(const std::string& folder) {
    std::vector<ExampleScene> examples;
    std::error_code problem;
    for (const auto& entry : fs::directory_iterator(folder, problem)) {
        const fs::path& file = entry.path();
        if (file.extension() != ".json" || file.filename() == kSchema) { continue; }
        ExampleScene example{file.string(), titleOf(file)};
        const fs::path thumbnail = fs::path(folder) / kThumbnails / (file.stem().string() + ".jpg");
        if (fs::exists(thumbnail, problem)) {
            if (auto image = loadImage8(thumbnail.string())) { example.thumbnail = thumbnailOf(**image); }
        }
        examples.push_back(std::move(example));
    }
    std::ranges::sort(examples, {}, &ExampleScene::path);
    return examples;
}

void Examples::list(JobQueue* jobs) {
    if (std::exchange(isAsked_, true)) { return; }
    jobs->start(
        [this]() -> JobQueue::Completion {
            const auto folder = examplesFolder();
            auto found = std::make_shared<std::vector<ExampleScene>>(folder ? listExamples(*folder)
                                                                            : std::vector<ExampleScene>());
            return [this, found] { scenes = std::move(*found); };
        },
        false);
}

}  // namespace glint
