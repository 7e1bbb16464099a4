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

void RenderSession::post(SceneEdit edit) { impl_->commandQueue.post(std::move(edit), std::nullopt); }

void RenderSession::resume(std::shared_ptr<const SceneDescription> scene, ResumePoint from) {
    impl_->commandQueue.post({std::move(scene), EditKind::Everything}, std::move(from));
}

void RenderSession::setLimits(const StopLimits& limits) {
    impl_->commandQueue.change([&](RenderRequest& request) { request.limits = limits; });
}

void RenderSession::setPaused(bool paused) {
    impl_->commandQueue.change([&](RenderRequest& request) { request.paused = paused; });
}

void RenderSession::restart() { impl_->commandQueue.postRestart(); }

void RenderSession::setInteracting(bool interacting) {
    impl_->commandQueue.change([&](RenderRequest& request) { request.interacting = interacting; });
}

void RenderSession::request(uint32_t aovs, bool standardError) {
    impl_->commandQueue.change([&](RenderRequest& request) {
        request.aovs = aovs;
        request.standardError = standardError;
    });
}

void RenderSession::requestErrorMaps(bool wanted) {
    impl_->commandQueue.change([&](RenderRequest& request) { request.errorMaps = wanted; });
}

void RenderSession::requestPhotonStatistics(bool wanted) {
    impl_->commandQueue.change([&](RenderRequest& request) { request.photonStatistics = wanted; });
}

void RenderSession::setComparing(bool comparing) {
    impl_->commandQueue.change([&](RenderRequest& request) { request.compare = comparing; });
}

std::shared_ptr<const FilmSnapshot> RenderSession::otherSnapshot() const {
    return impl_->published.otherSnapshot();
}

std::shared_ptr<const FilmSnapshot> RenderSession::snapshot() const { return impl_->published.snapshot(); }

SessionStatus RenderSession::status() const { return impl_->published.status(); }

std::shared_ptr<const ConvergenceCurve> RenderSession::convergenceCurve(IntegratorKind integrator) const {
    return impl_->published.curve(integrator);
}

SessionState RenderSession::wait(double seconds) {
    return impl_->published.wait(impl_->commandQueue.ticket(), seconds);
}

std::future<std::optional<SessionCapture>> RenderSession::captureLater() {
    CapturePromise promise;
    std::future<std::optional<SessionCapture>> future = promise.get_future();
    impl_->commandQueue.postCapture(std::move(promise));
    return future;
}

std::optional<SessionCapture> RenderSession::capture() { return captureLater().get(); }

}  // namespace glint
