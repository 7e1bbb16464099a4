#include "viewer/model/scene_files.h"

#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "engine/base/log.h"
#include "engine/io/scene_json.h"
#include "engine/io/scene_loader.h"

namespace glint {

namespace {

struct LoadedScene {
    Result<SceneDescription> whole;
    std::shared_ptr<SceneDescription> part{};  ///< without files that are missing, where that is all
};

LoadedScene load(const SceneReading& from) {
    LoadedScene loaded{loadScene(from.path, from.options)};
    if (loaded.whole || from.options.allowMissing) { return loaded; }
    LoadOptions options = from.options;
    options.allowMissing = true;
    if (auto part = loadScene(from.path, options)) {
        loaded.part = std::make_shared<SceneDescription>(std::move(*part));
    }
    return loaded;
}

}  // namespace

void SceneFiles::open(const std::string& path) {
    if (path.empty()) { return; }
    if (opening_) {
        next_ = path;
        return;
    }
    opening_ = true;
    dismissError();
    auto from = std::make_shared<SceneReading>(path == reading.path ? reading : SceneReading{.path = path});
    jobs_->start(
        [this, from]() -> JobQueue::Completion {
            auto loaded = std::make_shared<LoadedScene>(load(*from));
            from->choices = readSceneChoices(from->path);
            return [this, loaded, from] {
                Result<SceneDescription>& whole = loaded->whole;
                opening_ = false;
                if (!whole) { logError("{}", whole.error().format()); }
                if (!next_.empty()) { return open(std::exchange(next_, "")); }
                if (whole || from->path == reading.path) { reading = std::move(*from); }
                if (whole) {
                    adopt_(std::move(*whole));
                } else {
                    error_ = whole.error();
                    part_ = std::move(loaded->part);
                    notice_->show(error_->format(), true);
                }
                isReload_ = false;
            };
        },
        false);
}

void SceneFiles::openWithoutFiles() {
    if (!part_) { return; }
    const std::shared_ptr<SceneDescription> part = std::move(part_);
    reading = {.path = part->path, .options = {.allowMissing = true}};
    adopt_(std::move(*part));
}

void SceneFiles::reload(const std::string& path) {
    isReload_ = true;
    open(path);
}

void SceneFiles::add(const std::string& path) {
    jobs_->start(
        [this, path]() -> JobQueue::Completion {
            auto loaded = std::make_shared<Result<SceneDescription>>(loadScene(path));
            return [this, loaded] {
                if (!*loaded) { return notice_->show(loaded->error().format(), true); }
                add_(std::move(loaded->value()));
            };
        },
        false);
}

void SceneFiles::browse() {
    dialog.ask({"Open a scene", opened, false, [this](const std::string& path) { open(path); }});
}

void SceneFiles::saveAs(const std::shared_ptr<const SceneDescription>& scene) {
    dialog.ask({"Save the scene as", saved, true, [this, scene](const std::string& path) {
                    saved = std::filesystem::path(path).has_extension() ? path : path + ".json";
                    save(scene);
                }});
}

void SceneFiles::save(const std::shared_ptr<const SceneDescription>& scene) {
    if (const Status free = inputs_->checkIsNoInput(saved); !free) { return notice_->tell(free, ""); }
    guard_->save(saved, [this, path = saved, scene] { startSave(path, scene); });
}

void SceneFiles::startSave(const std::string& path, const std::shared_ptr<const SceneDescription>& scene) {
    jobs_->start(
        [this, path, scene]() -> JobQueue::Completion {
            const Status result = scene ? saveSceneJson(*scene, path) : Status(Error{"no scene is open", {}});
            return [this, path, scene, result] {
                if (result) { noteSaved_(scene); }
                notice_->tell(result, fmt::format("Saved {}", Notice::placeOf(path)));
            };
        },
        true);
}

}  // namespace glint
