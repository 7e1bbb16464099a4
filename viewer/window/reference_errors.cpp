#include "viewer/window/reference_errors.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "engine/base/log.h"
#include "engine/base/thread_priority.h"
#include "engine/io/atomic_file.h"
#include "engine/io/exr_io.h"
#include "engine/io/image_io.h"
#include "engine/report/metrics.h"

namespace glint {
namespace {

constexpr double kGrowth = 1.15;  // of the passes from one point to the next
constexpr size_t kWorthKeeping = 5;

double meanOf(const ImageF& image) {
    double sum = 0.0;
    for (const float value : image.rgb) {
        sum += static_cast<double>(value);
    }
    return image.rgb.empty() ? 0.0 : sum / static_cast<double>(image.rgb.size());
}

Status readExr(std::string_view bytes, LoadedReference* reference) {
    auto exr = decodeExr(bytes, reference->path);
    if (!exr) { return exr.error(); }
    auto image = exrColor(*exr, reference->path);
    if (!image) { return image.error(); }
    reference->image = std::move(*image);
    reference->attributes = std::move(exr->attributes);
    return {};
}

Status readOther(LoadedReference* reference) {
    const auto source = loadImage(reference->path);
    if (!source) { return source.error(); }
    reference->isEightBit = source->bytes != nullptr;
    const auto image = reference->isEightBit ? loadImageF(reference->path)
                                             : Result<std::shared_ptr<const ImageF>>(source->floats);
    if (!image) { return image.error(); }
    reference->image = **image;
    return {};
}

Result<std::shared_ptr<const LoadedReference>> loadReference(const std::string& path) {
    auto bytes = readFile(path);
    if (!bytes) { return bytes.error(); }
    auto image = std::make_shared<LoadedReference>();
    image->path = path;
    if (Status read = looksLikeExr(*bytes) ? readExr(*bytes, image.get()) : readOther(image.get()); !read) {
        return read.error();
    }
    image->mean = meanOf(image->image);
    return std::shared_ptr<const LoadedReference>(std::move(image));
}

Result<ReferencePoint> compare(const FilmSnapshot& snapshot, const LoadedReference& reference) {
    const ImageF test{snapshot.width, snapshot.height, snapshot.radiance};
    const auto metrics = compareImages(test, reference.image, {.ssim = false, .flip = false, .threads = 1});
    if (!metrics) { return metrics.error(); }
    ReferencePoint point{.passes = snapshot.passes, .renderSeconds = snapshot.renderSeconds};
    point.relativeRmse = metrics->relativeRmse();
    point.rmseOverMean = reference.mean > 0.0 ? metrics->rmse / reference.mean : metrics->rmse;
    point.mape = metrics->mape;
    point.relativeBias = metrics->relativeBias;
    return point;
}

}  // namespace

double ReferencePoint::error(ReferenceMetric metric) const {
    if (metric == ReferenceMetric::RelativeRmse) { return relativeRmse; }
    return metric == ReferenceMetric::RmseOverMean ? rmseOverMean : mape;
}

void ReferenceErrors::load(const std::string& path) {
    if (path.empty()) { return; }
    if (loading_) {
        next_ = path;
        return;
    }
    loading_ = true;
    loadError_.reset();
    jobs_.start(
        [this, path]() -> JobQueue::Completion {
            auto loaded =
                std::make_shared<Result<std::shared_ptr<const LoadedReference>>>(loadReference(path));
            return [this, loaded] {
                loading_ = false;
                if (!*loaded) { logError("{}", loaded->error().format()); }
                if (!next_.empty()) { return load(std::exchange(next_, "")); }
                if (!*loaded) {
                    loadError_ = loaded->error();
                    return;
                }
                image_ = std::move(loaded->value());
                forgetPoints();
                logInfo("Reference {}: {}x{} pixels", image_->path, image_->image.width,
                        image_->image.height);
            };
        },
        false);
}

void ReferenceErrors::clear() {
    next_.clear();
    image_.reset();
    loadError_.reset();
    forgetPoints();
}

void ReferenceErrors::forgetPoints() {
    for (IntegratorState& integratorState : integratorStates_) {
        integratorState.points.clear();
        integratorState.before.clear();
    }
}

std::string ReferenceErrors::mismatch(int width, int height) const {
    if (!image_ || (image_->image.width == width && image_->image.height == height)) { return ""; }
    return fmt::format("The reference has {} × {} pixels, the picture {} × {}: they cannot be compared.",
                       image_->image.width, image_->image.height, width, height);
}

void ReferenceErrors::refresh() { jobs_.runCompletions(); }

bool ReferenceErrors::measuring() const {
    return std::ranges::any_of(integratorStates_, &IntegratorState::measuring);
}

void ReferenceErrors::follow(IntegratorKind kind, const ConvergenceCurve& curve) {
    IntegratorState& integratorState = integratorStates_[static_cast<size_t>(kind)];
    const double began = curve.empty() ? 0.0 : curve.points().front().renderSeconds;
    if (integratorState.filmBegan == began) { return; }
    integratorState.filmBegan = began;
    if (integratorState.points.size() >= kWorthKeeping) {
        integratorState.before = std::move(integratorState.points);
    }
    integratorState.points.clear();
}

void ReferenceErrors::observe(const std::shared_ptr<const FilmSnapshot>& snapshot, bool resting) {
    IntegratorState& integratorState = integratorStates_[static_cast<size_t>(snapshot->integrator)];
    if (snapshot->previewScale != 1 || integratorState.filmBegan == 0.0) { return; }
    // A checkpoint can lead back.
    while (!integratorState.points.empty() && integratorState.points.back().passes > snapshot->passes) {
        integratorState.points.pop_back();
    }
    if (!image_ || integratorState.measuring || !mismatch(snapshot->width, snapshot->height).empty()) {
        return;
    }
    const uint32_t last = integratorState.points.empty() ? 0 : integratorState.points.back().passes;
    const bool isDue = snapshot->passes >= kGrowth * last || resting;
    if (isDue && snapshot->passes > last) { measure(snapshot, &integratorState); }
}

void ReferenceErrors::measure(std::shared_ptr<const FilmSnapshot> snapshot,
                              IntegratorState* integratorState) {
    integratorState->measuring = true;
    const double filmBegan = integratorState->filmBegan;
    jobs_.start(
        [integratorState, filmBegan, this, snapshot = std::move(snapshot),
         reference = image_]() -> JobQueue::Completion {
            lowerThreadPriority();
            const Result<ReferencePoint> point = compare(*snapshot, *reference);
            return [integratorState, filmBegan, this, reference, point] {
                integratorState->measuring = false;
                const bool stale = integratorState->filmBegan != filmBegan || reference != image_;
                if (!point) {
                    logError("The reference cannot be compared: {}", point.error().format());
                } else if (!stale && (integratorState->points.empty() ||
                                      integratorState->points.back().passes < point->passes)) {
                    integratorState->points.push_back(*point);
                }
            };
        },
        false);
}

ConvergenceCurve asCurve(const std::vector<ReferencePoint>& points, ReferenceMetric metric) {
    ConvergenceCurve curve;
    for (const ReferencePoint& point : points) {
        const double error = point.error(metric);
        curve.add({.passes = point.passes,
                   .renderSeconds = point.renderSeconds,
                   .relativeError = error,
                   .relativeErrorLow = error,
                   .relativeErrorHigh = error});
    }
    return curve;
}

}  // namespace glint
