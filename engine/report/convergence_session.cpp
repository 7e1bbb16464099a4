// Limits are set before the scene is posted: no pass may run that nobody asked for.
#include "engine/report/convergence_session.h"

#include <fmt/format.h>

#include "engine/render/denoised_snapshot.h"

namespace glint {
namespace {

constexpr double kPollSeconds = 0.1;

std::string progressText(const std::string& prefix, const SessionStatus& status, const StopLimits& limits) {
    std::string text = fmt::format("{}: pass {}", prefix, status.passes);
    if (limits.renderSeconds > 0.0) {
        return text + fmt::format(", {:.1f} of {:.4g} s", status.renderSeconds, limits.renderSeconds);
    }
    return text + fmt::format(" of {}, {:.1f} s", limits.passes, status.renderSeconds);
}

bool isReached(const SessionStatus& status, const StopLimits& limits) {
    return (limits.passes > 0 && status.passes >= limits.passes) ||
           (limits.renderSeconds > 0.0 && status.renderSeconds >= limits.renderSeconds) ||
           limits.relativeError > 0.0;
}

}  // namespace

MeasuredSession::MeasuredSession(std::shared_ptr<SceneDescription> scene, const ConvergenceHost& host,
                                 std::unique_ptr<Backend> backend, int threads)
    : scene_(std::move(scene)), host_(host) {
    SessionOptions options;
    options.previews = false;
    options.snapshots = false;
    options.lowPriority = false;
    options.threads = threads;
    session_ = std::make_unique<RenderSession>(std::move(backend), options);
}

Result<std::unique_ptr<MeasuredSession>> MeasuredSession::start(const SceneDescription& scene,
                                                                const VariantSettings& settings,
                                                                const ConvergenceHost& host) {
    auto backend = host.makeBackend(settings);
    if (!backend) { return backend.error(); }
    auto own = std::make_shared<SceneDescription>(scene);
    own->options = settings.options;
    own->sppm = settings.sppm;
    std::unique_ptr<MeasuredSession> session(
        new MeasuredSession(std::move(own), host, std::move(*backend), settings.threads));
    if (settings.denoise) { session->aovs_ = kDenoisingAovs; }
    return session;
}

MeasuredSession::Outcome MeasuredSession::runTo(const StopLimits& limits, const std::string& progressPrefix) {
    // Also here: work may come in pieces so small that none of them is waited for below.
    if (host_.mustStop()) { return Outcome::Interrupted; }
    session_->request({.limits = limits, .aovs = aovs_, .aovsEndWithFilm = true});
    if (posted_ == 0) { posted_ = session_->post({scene_, EditKind::Everything}); }
    for (;;) {
        const SessionState state = session_->wait(kPollSeconds);
        const SessionStatus status = session_->status();
        if (state == SessionState::Failed) { return Outcome::Failed; }
        // On a busy machine the wait may end before the session has even looked at the new limits.
        if (state == SessionState::Finished && status.ticket == posted_ && isReached(status, limits)) {
            return Outcome::Reached;
        }
        if (host_.mustStop()) { return Outcome::Interrupted; }
        if (host_.onProgress) { host_.onProgress(progressText(progressPrefix, status, limits)); }
    }
}

void MeasuredSession::restartWithSeed(uint32_t seed) {
    auto next = std::make_shared<SceneDescription>(*scene_);
    next->options.seed = seed;
    scene_ = std::move(next);
    session_->request({.limits = {.passes = 1}});
    posted_ = session_->post({scene_, EditKind::Options});
}

}  // namespace glint
