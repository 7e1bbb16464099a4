// The session's outside: a mailbox, a bulletin and the thread between them.
#include "engine/render/render_session.h"

#include <thread>
#include <utility>

#include "engine/render/bulletin.h"
#include "engine/render/mailbox.h"
#include "engine/render/session_worker.h"

namespace glint {

class RenderSession::Impl {
  public:
    Impl(std::unique_ptr<Backend> backend, SessionOptions options)
        : worker_(std::move(backend), std::move(options), &mailbox, &bulletin),
          thread_([this] { worker_.run(); }) {}
    ~Impl() {
        mailbox.postQuit();
        thread_.join();
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    Mailbox mailbox;
    Bulletin bulletin;

  private:
    SessionWorker worker_;
    std::thread thread_;
};

RenderSession::RenderSession(std::unique_ptr<Backend> backend, SessionOptions options)
    : impl_(std::make_unique<Impl>(std::move(backend), std::move(options))) {}

RenderSession::~RenderSession() = default;

void RenderSession::post(SceneEdit edit) { impl_->mailbox.post(std::move(edit), std::nullopt); }

void RenderSession::resume(std::shared_ptr<const SceneDescription> scene, ResumePoint from) {
    impl_->mailbox.post({std::move(scene), EditKind::Everything}, std::move(from));
}

void RenderSession::setLimits(const StopLimits& limits) {
    impl_->mailbox.change([&](Wishes& wishes) { wishes.limits = limits; });
}

void RenderSession::setPaused(bool paused) {
    impl_->mailbox.change([&](Wishes& wishes) { wishes.paused = paused; });
}

void RenderSession::restart() { impl_->mailbox.postRestart(); }

void RenderSession::setInteracting(bool interacting) {
    impl_->mailbox.change([&](Wishes& wishes) { wishes.interacting = interacting; });
}

void RenderSession::request(uint32_t aovs, bool standardError) {
    impl_->mailbox.change([&](Wishes& wishes) {
        wishes.aovs = aovs;
        wishes.standardError = standardError;
    });
}

void RenderSession::requestErrorMaps(bool wanted) {
    impl_->mailbox.change([&](Wishes& wishes) { wishes.errorMaps = wanted; });
}

void RenderSession::requestPhotonStatistics(bool wanted) {
    impl_->mailbox.change([&](Wishes& wishes) { wishes.photonStatistics = wanted; });
}

void RenderSession::setComparing(bool comparing) {
    impl_->mailbox.change([&](Wishes& wishes) { wishes.compare = comparing; });
}

std::shared_ptr<const FilmSnapshot> RenderSession::otherSnapshot() const {
    return impl_->bulletin.otherSnapshot();
}

std::shared_ptr<const FilmSnapshot> RenderSession::snapshot() const { return impl_->bulletin.snapshot(); }

SessionStatus RenderSession::status() const { return impl_->bulletin.status(); }

std::shared_ptr<const ConvergenceCurve> RenderSession::convergenceCurve(IntegratorKind integrator) const {
    return impl_->bulletin.curve(integrator);
}

SessionState RenderSession::wait(double seconds) {
    return impl_->bulletin.wait(impl_->mailbox.ticket(), seconds);
}

std::future<std::optional<SessionCapture>> RenderSession::captureLater() {
    CapturePromise promise;
    std::future<std::optional<SessionCapture>> future = promise.get_future();
    impl_->mailbox.postCapture(std::move(promise));
    return future;
}

std::optional<SessionCapture> RenderSession::capture() { return captureLater().get(); }

}  // namespace glint
