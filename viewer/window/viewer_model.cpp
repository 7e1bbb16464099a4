#include "viewer/window/viewer_model.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "engine/base/log.h"
#include "engine/io/scene_loader.h"
#include "engine/io/used_assets.h"
#include "engine/scene/object_box.h"
#include "engine/scene/scene_diff.h"
#include "engine/scene/scene_use.h"
#include "viewer/window/camera_controller.h"

namespace glint {
namespace {

constexpr uint32_t kAllAovs =
    kAovAlbedo | kAovShadingNormal | kAovGeometricNormal | kAovDepth | kAovObjectId | kAovMaterialId;

uint32_t aovOf(ShownImage shown) {
    switch (shown) {
        case ShownImage::Albedo:
            return kAovAlbedo;
        case ShownImage::ShadingNormal:
            return kAovShadingNormal;
        case ShownImage::GeometricNormal:
            return kAovGeometricNormal;
        case ShownImage::Depth:
            return kAovDepth;
        case ShownImage::ObjectId:
            return kAovObjectId;
        case ShownImage::MaterialId:
            return kAovMaterialId;
        case ShownImage::Radiance:
        case ShownImage::StandardError:
        case ShownImage::Bias:
        case ShownImage::ErrorBound:
        case ShownImage::ReferenceError:
        case ShownImage::Radius:
        case ShownImage::PhotonCount:
        case ShownImage::VisiblePoints:
            break;
    }
    return 0;
}

bool carries(const FilmSnapshot& snapshot, ShownImage shown) {
    if (shown == ShownImage::Radiance || shown == ShownImage::ReferenceError) { return true; }
    if (shown == ShownImage::StandardError) { return !snapshot.standardError.empty(); }
    if (shown == ShownImage::ErrorBound) { return !snapshot.errorBound.empty(); }
    if (isOfSppm(shown) && snapshot.integrator != IntegratorKind::Sppm) { return true; }
    if (shown == ShownImage::Bias) { return !snapshot.bias.empty(); }
    if (isOfPhotons(shown)) { return !snapshot.maps.empty(); }
    return snapshot.aovs && snapshot.aovs->passes() > 0;
}

}  // namespace

ViewerModel::ViewerModel(std::unique_ptr<Backend> backend) : session_(std::move(backend)) {
    curves_.fill(std::make_shared<const ConvergenceCurve>());
    curvesBefore_ = curves_;
}

void ViewerModel::adopt(SceneDescription scene) {
    for (const std::string& warning : scene.warnings) {
        logWarning("{}: {}", scene.path, warning);
    }
    logInfo("Opened {}: {} objects, {} materials, {} lights, {}x{} pixels", scene.path, scene.objects.size(),
            scene.materials.size(), scene.lights.size(), scene.resolution.width, scene.resolution.height);
    isAnotherScene_ = scene.path != draft_.path;
    if (isAnotherScene_) { curvesBefore_.fill(std::make_shared<const ConvergenceCurve>()); }
    ++adoptions_;
    readingAssets_ = false;
    assetError_.reset();
    draft_ = std::move(scene);
    posted_ = std::make_shared<const SceneDescription>(draft_);
    cameraOfFile_ = draft_.camera;
    bounds_ = sceneBounds(draft_);
    files.scene = draft_.path;
    selectedMaterial = 0;
    selectedLight = 0;
    openError_.reset();
    replayCommand_.clear();
    // An orbit must not change the focus of a scene whose author focused elsewhere.
    const float distance = targetDistance(draft_.camera);
    focusFollowsTarget = draft_.camera.apertureDiameter <= 0.0f ||
                         std::fabs(distance - draft_.camera.focalDistance) <= 1e-3f * distance;
    postRequest();  // first, so that not a pass too many is made
    awaitedEdit_ = session_.post({posted_, EditKind::Everything});
}

void ViewerModel::open(const std::string& path) {
    if (path.empty()) { return; }
    if (opening_) {
        openNext_ = path;
        return;
    }
    opening_ = true;
    openError_.reset();
    jobs_.start(
        [this, path]() -> JobQueue::Completion {
            auto loaded = std::make_shared<Result<SceneDescription>>(loadScene(path));
            return [this, loaded] {
                opening_ = false;
                if (!*loaded) { logError("{}", loaded->error().format()); }
                if (!openNext_.empty()) { return open(std::exchange(openNext_, "")); }
                if (*loaded) {
                    adopt(std::move(loaded->value()));
                } else {
                    openError_ = loaded->error();
                }
            };
        },
        false);
}

void ViewerModel::restart() {
    awaitedEdit_ = session_.restart();
    logInfo("Restarted by hand");
}

void ViewerModel::refresh() {
    jobs_.runCompletions();
    status_ = session_.status();
    snapshot_ = session_.snapshot();
    refreshOther();
    const bool isShown = status_.ticket >= awaitedEdit_ && imageIsCurrent();
    if (isShown || status_.refusedTicket >= awaitedEdit_ || status_.state == SessionState::Failed) {
        awaitedEdit_ = 0;
    }
    if (pendingExr_ && status_.aovPasses > 0) { startExr(); }
    refreshConvergence();
    isAnotherScene_ = isAnotherScene_ && awaitedEdit_ != 0;
    autosave();
}

void ViewerModel::takeCurve(IntegratorKind kind) {
    constexpr size_t kWorthKeeping = 8;
    auto& shown = curves_[static_cast<size_t>(kind)];
    auto now = session_.convergenceCurve(kind);
    const auto began = [](const ConvergenceCurve& curve) { return curve.points().front().renderSeconds; };
    const bool isAnother = !shown->empty() && (now->empty() || began(*now) != began(*shown));
    if (isAnother && !isAnotherScene_ && shown->points().size() >= kWorthKeeping) {
        curvesBefore_[static_cast<size_t>(kind)] = std::move(shown);
    }
    shown = std::move(now);
}

/// While the picture moves, an other one that is an edit old is better than none: it would flicker.
void ViewerModel::refreshOther() {
    std::shared_ptr<const FilmSnapshot> other;
    if (display.split && snapshot_) {
        for (const IntegratorKind kind : request_.compare) {
            if (kind != snapshot_->integrator) { other = session_.snapshot(kind); }
        }
    }
    const bool mayStay = display.split && otherSnapshot_ && snapshot_ && snapshot_->previewScale > 1 &&
                         otherSnapshot_->integrator != snapshot_->integrator;
    if (other || !mayStay) { otherSnapshot_ = std::move(other); }
}

void ViewerModel::refreshConvergence() {
    const bool wasLoading = reference.loading();
    reference.refresh();
    if (wasLoading && !reference.loading()) { tellOfReference(); }
    for (const IntegratorKind kind : {IntegratorKind::PathTracing, IntegratorKind::Sppm}) {
        takeCurve(kind);
        reference.follow(kind, *curve(kind));
    }
    referenceFit.check(reference.image(), posted_, !request_.interacting);
    if (awaitedEdit_ != 0 || !usableReference()) {
        return;  // what is shown may be of the scene before an edit
    }
    const bool resting = status_.state == SessionState::Finished || status_.state == SessionState::Paused;
    for (const auto& shown : {snapshot_, otherSnapshot_}) {
        if (shown) { reference.observe(shown, resting); }
    }
}

std::shared_ptr<const LoadedReference> ViewerModel::usableReference() const {
    const auto& image = reference.image();
    const Resolution& size = draft_.resolution;
    const bool isUsable = image && reference.mismatch(size.width, size.height).empty() &&
                          (referenceFit.fits() || referenceFit.useAnyway);
    return isUsable ? image : nullptr;
}

void ViewerModel::finishMotion() {
    request_.interacting = false;
    session_.request(request_);
}

EditKind ViewerModel::commitEdits(bool held) {
    if (!posted_) { return EditKind::None; }
    if (focusFollowsTarget) {
        const bool moved = draft_.camera.position != posted_->camera.position ||
                           draft_.camera.target != posted_->camera.target;
        if (moved) { draft_.camera.focalDistance = targetDistance(draft_.camera); }
    }
    EditKind kinds = differences(*posted_, draft_);
    std::shared_ptr<const SceneDescription> ready;
    if (kinds != EditKind::None && !lackingAssets(draft_).empty()) {
        readAssets();
        ready = std::make_shared<const SceneDescription>(withoutLacking(draft_, *posted_));
        kinds = differences(*posted_, *ready);
    }
    if (kinds != EditKind::None) {
        posted_ = ready ? ready : std::make_shared<const SceneDescription>(draft_);
        if (held) {
            request_.interacting = true;
            session_.request(request_);
        }
        awaitedEdit_ = session_.post({posted_, kinds});
        replayCommand_.clear();
    }
    postRequest();
    return kinds;
}

void ViewerModel::readAssets() {
    if (readingAssets_) { return; }
    readingAssets_ = true;
    assetError_.reset();
    jobs_.start(
        [this, adoption = adoptions_,
         asked = std::make_shared<const SceneDescription>(draft_)]() -> JobQueue::Completion {
            auto read = std::make_shared<const CompletedScene>(completeScene(*asked));
            return [this, adoption, asked, read] {
                if (adoption == adoptions_) { takeReadAssets(*asked, *read); }
            };
        },
        false);
}

void ViewerModel::takeReadAssets(const SceneDescription& asked, const CompletedScene& read) {
    readingAssets_ = false;
    if (!read.error) {
        takeAssets(read.scene, &draft_);
    } else {
        assetError_ = read.error;
        finishFileJob(*read.error, "");
        SceneDescription tried = draft_;
        takeAssets(read.scene, &tried);
        const SceneDescription kept = withoutLacking(tried, *posted_);
        draft_.environment = kept.environment;
        for (size_t i = 0; i < draft_.materials.size(); ++i) {
            const std::vector<int> before = inputTextures(asked.materials[i]);
            const std::vector<int> keptTextures = inputTextures(kept.materials[i]);
            const std::vector<int*> textures = inputTextures(&draft_.materials[i]);
            for (size_t input = 0; input < textures.size(); ++input) {
                const bool wasAsked = *textures[input] == before[input];  // not a choice made since
                *textures[input] = wasAsked ? keptTextures[input] : *textures[input];
            }
        }
    }
    commitEdits(false);
}

void ViewerModel::postRequest() {
    request_.limits = limits;
    request_.paused = paused;
    request_.aovs = files.exrLayers || pendingExr_ ? kAllAovs : aovOf(display.shown);
    request_.standardError = display.shown == ShownImage::StandardError;
    request_.errorMaps = display.shown == ShownImage::Bias || display.shown == ShownImage::ErrorBound;
    request_.integratorMaps = isOfPhotons(display.shown);
    request_.compare.clear();
    if (display.split) { request_.compare = {IntegratorKind::PathTracing, IntegratorKind::Sppm}; }
    session_.request(request_);
}

bool ViewerModel::carriesShownImage() const {
    if (!snapshot_ || !carries(*snapshot_, display.shown)) { return false; }
    return !display.split ||
           (otherSnapshot_ && otherSnapshot_->previewScale == 1 && carries(*otherSnapshot_, display.shown));
}

bool ViewerModel::imageIsCurrent() const {
    return snapshot_ && snapshot_->previewScale == 1 && snapshot_->ticket == status_.ticket;
}

}  // namespace glint
