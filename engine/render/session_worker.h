// The render thread's loop: take commands, rebuild what an edit names, run the next pass, show it.
//
// Everything here belongs to the render thread; the command queue and the published state are the only ways
// in and out.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "engine/render/pass_runner.h"
#include "engine/render/scene_keeper.h"
#include "engine/render/snapshot_publisher.h"

namespace glint {

class SessionWorker {
  public:
    SessionWorker(std::unique_ptr<Backend> backend, SessionOptions options, CommandQueue* queue,
                  PublishedState* published);
    /// Until Commands::quit. Never throws: what goes wrong becomes SessionState::Failed.
    void run();

  private:
    void runOnce(Commands commands);
    void fail(std::string_view why) noexcept;

    void takeEdit(Commands commands);
    void showFirstFrame(const SceneEdit& edit);
    void goOnFrom(ResumePoint resume);
    void publishCurves(const std::vector<IntegratorKind>& kinds);

    NextPass next(const RenderRequest& request) const;
    void runPass(const NextPass& pass);
    void showIfDue();

    void serveCaptures();
    void answerCaptures();
    SessionState state() const;
    MemoryUse memoryUse() const;
    void setStatus();

    std::unique_ptr<Backend> backend_;
    SessionOptions options_;
    CommandQueue* queue_;
    PublishedState* published_;

    SessionStatus status_;
    RenderRequest request_;
    uint64_t messages_ = 0;  ///< that have been taken
    std::vector<CapturePromise> captures_;
    bool failed_ = false;

    SceneKeeper keeper_;
    SessionImages images_;
    PassRunner passes_;
    SnapshotPublisher snapshots_;
};

}  // namespace glint
