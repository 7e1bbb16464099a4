#include "viewer/model/reference_errors.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "engine/base/log.h"
#include "engine/base/thread_priority.h"
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
    auto image = decodeExrColor(bytes, reference->path);
    if (!image) { return image.error(); }
    if (Status finite = checkFinite(image->color, reference->path); !finite) { return finite; }
    reference->image = std::move(image->color);
    reference->attributes = std::move(image->attributes);
    return {};
}

Status readOther(const std::string& bytes, LoadedReference* reference) {
    const auto image = decodeImage(bytes, reference->path);
    if (!image) { return image.error(); }
    reference->isEightBit = image->bytes != nullptr;
    reference->image = *linearColors(*image);
    return checkFinite(reference->image, reference->path);
}

Result<std::shared_ptr<const LoadedReference>> loadReference(const std::string& path) {
    auto bytes = readImageFile(path);
    if (!bytes) { return bytes.error(); }
    auto image = std::make_shared<LoadedReference>();
    image->path = path;
    if (Status read = looksLikeExr(*bytes) ? readExr(*bytes, image.get()) : readOther(*bytes, image.get());
        !read) {
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
    point.pictureError = metrics->pictureError;
    point.relativeRmse = metrics->relativeRmse();
    point.rmseOverMean = metrics->rmse / reference.mean;
    point.mape = metrics->mape;
    point.relativeBias = metrics->relativeBias;
    return point;
}

}  // namespace

double ReferencePoint::error(ReferenceMetric metric) const {
    switch (metric) {
        case ReferenceMetric::PictureError:
            return pictureError;
        case ReferenceMetric::RelativeRmse:
            return relativeRmse;
        case ReferenceMetric::RmseOverMean:
            return rmseOverMean;
        case ReferenceMetric::Mape:
            break;
    }
    return mape;
}

void ReferenceErrors::load(const std::string& path, const Resolution& image) {
    if (path.empty()) { return; }
    image_ = image;
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
                Status taken = *loaded ? whyWorse(***loaded) : Status(loaded->error());
                if (!taken) { logError("{}", taken.error().format()); }
                if (!next_.empty()) { return load(std::exchange(next_, ""), image_); }
                if (!taken) {
                    loadError_ = taken.error();
                    return;
                }
                loaded_ = std::move(loaded->value());
                forgetPoints();
                logInfo("Reference {}: {}x{} pixels", loaded_->path, loaded_->image.width,
                        loaded_->image.height);
            };
        },
        false);
}

/// Error: the reference before can be compared with the picture, and this one cannot.
Status ReferenceErrors::whyWorse(const LoadedReference& reference) const {
    const auto fits = [&](const ImageF& image) {
        return image.width == image_.width && image.height == image_.height;
    };
    if (!loaded_ || !fits(loaded_->image) || fits(reference.image)) { return {}; }
    return Error{fmt::format("the picture has {} × {} pixels, this reference {} × {}; the one before stays",
                             image_.width, image_.height, reference.image.width, reference.image.height),
                 {reference.path, 0, 0, ""}};
}

void ReferenceErrors::clear() {
    next_.clear();
    loaded_.reset();
    loadError_.reset();
    forgetPoints();
}

void ReferenceErrors::forgetPoints() {
    for (Series& series : series_) {
        series.points.clear();
        series.before.clear();
    }
}

std::string ReferenceErrors::mismatch(int width, int height) const {
    if (!loaded_) { return ""; }
    if (!(loaded_->mean > 0.0)) { return "The reference is black: an error relative to it has no meaning."; }
    if (loaded_->image.width == width && loaded_->image.height == height) { return ""; }
    return fmt::format("The reference has {} × {} pixels, the picture {} × {}: they cannot be compared.",
                       loaded_->image.width, loaded_->image.height, width, height);
}

void ReferenceErrors::refresh() { jobs_.runCompletions(); }

bool ReferenceErrors::measuring() const { return std::ranges::any_of(series_, &Series::measuring); }

void ReferenceErrors::follow(IntegratorKind kind, const ConvergenceCurve& curve) {
    Series& series = series_[static_cast<size_t>(kind)];
    const double began = curve.empty() ? 0.0 : curve.points().front().renderSeconds;
    if (series.filmBegan == began) { return; }
    series.filmBegan = began;
    if (series.points.size() >= kWorthKeeping) { series.before = std::move(series.points); }
    series.points.clear();
}

void ReferenceErrors::observe(const std::shared_ptr<const FilmSnapshot>& snapshot, bool resting) {
    Series& series = series_[static_cast<size_t>(snapshot->integrator)];
    if (snapshot->previewScale != 1 || series.filmBegan == 0.0) { return; }
    // A checkpoint can lead back.
    while (!series.points.empty() && series.points.back().passes > snapshot->passes) {
        series.points.pop_back();
    }
    if (!loaded_ || series.measuring || !mismatch(snapshot->width, snapshot->height).empty()) { return; }
    const uint32_t last = series.points.empty() ? 0 : series.points.back().passes;
    const bool isDue = snapshot->passes >= kGrowth * last || resting;
    if (isDue && snapshot->passes > last) { measure(snapshot, &series); }
}

void ReferenceErrors::measure(std::shared_ptr<const FilmSnapshot> snapshot, Series* series) {
    series->measuring = true;
    const double filmBegan = series->filmBegan;
    jobs_.start(
        [series, filmBegan, this, snapshot = std::move(snapshot),
         reference = loaded_]() -> JobQueue::Completion {
            lowerThreadPriority();
            const Result<ReferencePoint> point = compare(*snapshot, *reference);
            return [series, filmBegan, this, reference, point] {
                series->measuring = false;
                const bool stale = series->filmBegan != filmBegan || reference != loaded_;
                if (!point) {
                    logError("The reference cannot be compared: {}", point.error().format());
                } else if (!stale &&
                           (series->points.empty() || series->points.back().passes < point->passes)) {
                    series->points.push_back(*point);
                }
            };
        },
        false);
}

float errorAgainst(const LoadedReference& reference, const FilmSnapshot& snapshot, size_t pixel) {
    const float* t = snapshot.radiance.data() + 3 * pixel;
    const float* r = reference.image.rgb.data() + 3 * pixel;
    return (std::fabs(t[0] - r[0]) + std::fabs(t[1] - r[1]) + std::fabs(t[2] - r[2])) / 3.0f;
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
