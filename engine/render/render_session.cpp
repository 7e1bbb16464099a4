// The session's outside: a command queue, the published state and the thread between them.
#include "engine/render/render_session.h"

#include <thread>
#include <utility>

#include "engine/render/command_queue.h"
#include "engine/render/published_state.h"
#include "engine/render/session_worker.h"

namespace glint {

class RenderSession::Impl {
  public:
    Impl(std::unique_ptr<Backend> backend, SessionOptions options)
        : worker_(std::move(backend), std::move(options), &commandQueue, &published),
          thread_([this] { worker_.run(); }) {}
    ~Impl() {
        commandQueue.postQuit();
        thread_.join();
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    CommandQueue commandQueue;
    PublishedState published;

  private:
    SessionWorker worker_;
    std::thread thread_;
};

RenderSession::RenderSession(std::unique_ptr<Backend> backend, SessionOptions options)
    : impl_(std::make_unique<Impl>(std::move(backend), std::move(options))) {}

RenderSession::~RenderSession() = default;

EditTicket RenderSession::post(SceneEdit edit, FilmTake take) {
    return impl_->commandQueue.post(std::move(edit), take, std::nullopt);
}

EditTicket RenderSession::resume(std::shared_ptr<const SceneDescription> scene, ResumePoint from,
                                 FilmTake take) {
    return impl_->commandQueue.post({std::move(scene), EditKind::Everything}, take, std::move(from));
}

EditTicket RenderSession::restart() { return impl_->commandQueue.postRestart(); }

void RenderSession::request(const RenderRequest& request) { impl_->commandQueue.request(request); }

std::shared_ptr<const FilmSnapshot> RenderSession::snapshot() const { return impl_->published.snapshot(); }

std::shared_ptr<const FilmSnapshot> RenderSession::snapshot(IntegratorKind integrator) const {
    return impl_->published.snapshot(integrator);
}

std::shared_ptr<const BuiltScene> RenderSession::builtScene() const { return impl_->published.builtScene(); }

SessionStatus RenderSession::status() const { return impl_->published.status(); }

std::shared_ptr<const ConvergenceCurve> RenderSession::convergenceCurve(IntegratorKind integrator) const {
    return impl_->published.curve(integrator);
}

SessionState RenderSession::wait(double seconds) {
    return impl_->published.wait(impl_->commandQueue.messages(), seconds);
}

std::future<std::optional<SessionCapture>> RenderSession::captureLater() {
    CapturePromise promise;
    std::future<std::optional<SessionCapture>> future = promise.get_future();
    impl_->commandQueue.postCapture(std::move(promise));
    return future;
}

std::optional<SessionCapture> RenderSession::capture() { return captureLater().get(); }

}  // namespace glint
