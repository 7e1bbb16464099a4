#include "viewer/model/scene_files.h"

#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "engine/base/log.h"
#include "engine/io/scene_json.h"
#include "engine/io/scene_loader.h"

namespace glint {

void SceneFiles::open(const std::string& path) {
    if (path.empty()) { return; }
    if (opening_) {
        next_ = path;
        return;
    }
    opening_ = true;
    error_.reset();
    auto from = std::make_shared<SceneReading>(path == reading.path ? reading : SceneReading{.path = path});
    jobs_->start(
        [this, from]() -> JobQueue::Completion {
            auto loaded = std::make_shared<Result<SceneDescription>>(loadScene(from->path, from->options));
            from->choices = readSceneChoices(from->path);
            return [this, loaded, from] {
                opening_ = false;
                if (!*loaded) { logError("{}", loaded->error().format()); }
                if (!next_.empty()) { return open(std::exchange(next_, "")); }
                if (*loaded || from->path == reading.path) { reading = std::move(*from); }
                if (*loaded) {
                    adopt_(std::move(loaded->value()));
                } else {
                    error_ = loaded->error();
                    notice_->show(error_->format(), true);
                }
                isReload_ = false;
            };
        },
        false);
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
