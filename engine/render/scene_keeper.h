// The built scene of a session: what edits make of it, and which edits were refused.
#pragma once

#include <memory>

#include "engine/render/command_queue.h"
#include "engine/render/session_status.h"

namespace glint {

class SceneKeeper {
  public:
    SceneKeeper(Backend* backend, SceneBuildFunction build, int threads, const CommandQueue* queue)
        : backend_(backend), build_(std::move(build)), threads_(threads), queue_(queue) {}

    enum class Outcome {
        Taken,
        Refused,    ///< status->error says why; the scene before goes on
        Abandoned,  ///< given up for a newer scene, which waits
    };
    /// Builds what the edit changes and hands it to the back end. What was refused before is made up for: it
    /// is added to the edit's kinds. Kinds that left the built scene as it was are taken from them.
    Outcome take(SceneEdit* edit, SessionStatus* status);

    bool hasScene() const { return built_ != nullptr; }
    const std::shared_ptr<const BuiltScene>& built() const { return built_; }
    const MemoryUse& memory() const { return memory_; }

  private:
    Status rebuild(SceneEdit* edit, SessionStatus* status);

    Backend* backend_;
    SceneBuildFunction build_;
    int threads_;
    const CommandQueue* queue_;
    std::shared_ptr<const BuiltScene> built_;
    MemoryUse memory_;  ///< of built_
    EditKind refusedKinds_ = EditKind::None;
};

}  // namespace glint
