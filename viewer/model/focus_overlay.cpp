#include "viewer/model/focus_overlay.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <utility>

#include "engine/base/thread_priority.h"
#include "engine/render/first_hits.h"
#include "viewer/model/lens.h"

namespace glint {

struct FocusOverlay::Stop {
    std::atomic<bool> flag{false};
};

namespace {

constexpr int kMostDepths = 1 << 19;
constexpr int kMovingDepths = 1 << 14;  // a few milliseconds
constexpr float kLargestBlur = 64.0f;   // pixels; the colours are full from there on
constexpr float kSmoothStep = 0.1f;     // of the depth: more is another surface, not one that is cut

using Color = std::array<uint8_t, 4>;

constexpr Color kClear{0, 0, 0, 0};
constexpr Color kCut{255, 240, 60, 255};
constexpr Color kSharpTint{70, 235, 90, 110};
constexpr Color kBlurred{0, 0, 0, 120};

Color sharpColor(float blur, float sharpPixels) {
    return std::fabs(blur) <= sharpPixels ? kSharpTint : kBlurred;
}

/// Deeper the larger the circle is, on a logarithmic scale from the sharp ones on.
Color blurColor(float blur, float sharpPixels) {
    const float size = std::fabs(blur);
    if (size <= sharpPixels) { return kClear; }
    const float share = std::log2(size / sharpPixels) / std::log2(std::max(kLargestBlur / sharpPixels, 2.0f));
    const auto alpha = static_cast<uint8_t>(70.0f + 150.0f * std::clamp(share, 0.0f, 1.0f));
    return blur < 0.0f ? Color{40, 110, 255, alpha} : Color{255, 130, 20, alpha};
}

/// The plane in focus passes between two points of one surface.
bool isCut(float depth, float next, float focus) {
    const bool isBetween = (depth < focus) != (next < focus);
    return isBetween && depth > 0.0f && next > 0.0f && std::fabs(depth - next) < kSmoothStep * focus;
}

/// Through the middle of the lens.
bool seesTheSame(CameraData a, const CameraData& b) {
    a.lensRadius = b.lensRadius;
    a.focalDistance = b.focalDistance;
    a.blades = b.blades;
    a.bladeRotationRad = b.bladeRotationRad;
    return a == b;
}

int scaleFor(const Resolution& size, int mostDepths) {
    int scale = 1;
    while ((size.width / scale) * (size.height / scale) > mostDepths) {
        ++scale;
    }
    return scale;
}

bool isSameLens(const FocusOverlay::Wanted& a, const FocusOverlay::Wanted& b) {
    return a.kind == b.kind && a.sharpPixels == b.sharpPixels &&
           a.camera.apertureDiameter == b.camera.apertureDiameter &&
           a.camera.focalDistance == b.camera.focalDistance && a.camera.kind == b.camera.kind &&
           a.camera.verticalFovDeg == b.camera.verticalFovDeg && a.camera.viewHeight == b.camera.viewHeight &&
           a.resolution.height == b.resolution.height;
}

}  // namespace

std::vector<uint8_t> focusColors(const std::vector<float>& depths, int width, const Camera& camera,
                                 FocusOverlayKind kind, float sharpPixels, int imageHeight) {
    std::vector<uint8_t> colors;
    colors.reserve(4 * depths.size());
    const auto row = static_cast<size_t>(width);
    for (size_t i = 0; i < depths.size(); ++i) {
        const float depth = depths[i];
        // What is nowhere is at infinity.
        const float blur = blurPixels(camera, depth > 0.0f ? depth : kInfinity, imageHeight);
        Color color =
            kind == FocusOverlayKind::Sharp ? sharpColor(blur, sharpPixels) : blurColor(blur, sharpPixels);
        const bool hasRight = (i + 1) % row != 0;
        const bool hasBelow = i + row < depths.size();
        if (kind == FocusOverlayKind::Sharp &&
            ((hasRight && isCut(depth, depths[i + 1], camera.focalDistance)) ||
             (hasBelow && isCut(depth, depths[i + row], camera.focalDistance)))) {
            color = kCut;
        }
        colors.insert(colors.end(), color.begin(), color.end());
    }
    return colors;
}

FocusOverlay::FocusOverlay() : stop_(std::make_shared<Stop>()) {}

FocusOverlay::~FocusOverlay() { stop_->flag = true; }

bool FocusOverlay::isOf(const Depths* depths, const BuiltScene& scene, int scale) const {
    return depths != nullptr && depths->scale == scale && depths->scene->meshes == scene.meshes &&
           depths->scene->instances == scene.instances && seesTheSame(depths->scene->camera, scene.camera);
}

void FocusOverlay::start(const std::shared_ptr<const BuiltScene>& scene, const Resolution& size, int scale) {
    stop_->flag = true;  // one for another view
    stop_ = std::make_shared<Stop>();
    auto depths = std::make_shared<Depths>(
        Depths{scene, scale, std::max(size.width / scale, 1), std::max(size.height / scale, 1), {}});
    asked_ = depths;
    jobs_.start(
        [this, depths, stop = stop_]() -> JobQueue::Completion {
            lowerThreadPriority();
            depths->values = firstDepths(*depths->scene, depths->width, depths->height, stop->flag);
            return [this, depths] {
                if (asked_ == depths) { shown_ = std::exchange(asked_, nullptr); }
            };
        },
        true);
}

void FocusOverlay::color(const Wanted& wanted) {
    coloredFor_ = wanted;
    coloredOf_ = shown_;
    ++version_;
    colors_.clear();
    if (!shown_) { return; }
    colors_ = focusColors(shown_->values, shown_->width, wanted.camera, wanted.kind, wanted.sharpPixels,
                          wanted.resolution.height);
}

void FocusOverlay::refresh(const Wanted& wanted, const std::shared_ptr<const BuiltScene>& scene) {
    jobs_.runCompletions();
    isBehind_ = false;
    if (wanted.kind == FocusOverlayKind::None || !scene) {
        colors_.clear();
        coloredOf_ = shown_ = nullptr;
        return;
    }
    const int scale = scaleFor(wanted.resolution, wanted.isMoving ? kMovingDepths : kMostDepths);
    if (!isOf(shown_.get(), *scene, scale)) {
        isBehind_ = true;
        if (!isOf(asked_.get(), *scene, scale)) { start(scene, wanted.resolution, scale); }
    }
    if (coloredOf_ != shown_ || !isSameLens(coloredFor_, wanted)) { color(wanted); }
}

}  // namespace glint
