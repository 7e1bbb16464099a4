#include "engine/report/convergence_run.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "engine/render/denoised_snapshot.h"
#include "engine/render/session_clock.h"
#include "engine/render/snapshot.h"
#include "engine/report/convergence_schedule.h"
#include "engine/report/metrics.h"

namespace glint {
namespace {

using Outcome = MeasuredSession::Outcome;

/// A later seed that takes so many times the first one's time is given up: something else runs on
/// this machine.
constexpr double kMostSlowdown = 4.0;

/// Mean and spread over the seeds of each value of the last picture (Welford 1962).
struct ImageMoments {
    int count = 0;
    std::vector<double> mean, squares;

    void add(const ImageF& image) {
        mean.resize(image.rgb.size());
        squares.resize(image.rgb.size());
        ++count;
        for (size_t i = 0; i < image.rgb.size(); ++i) {
            const double value = static_cast<double>(image.rgb[i]);
            const double delta = value - mean[i];
            mean[i] += delta / count;
            squares[i] += delta * (value - mean[i]);
        }
    }
};

class VariantRunner {
  public:
    VariantRunner(const ConvergencePlan& plan, const ConvergenceVariant& variant,
                  const SceneDescription& scene, const ReferenceImage& reference, const ConvergenceHost& host)
        : plan_(plan), scene_(scene), reference_(reference), host_(host) {
        result.variant = variant;
        result.settings = variant.applyTo(plan.defaults);
        moments_ = plan.imageMoments;
        if (moments_.empty()) {
            moments_ = decadesOf(plan.seconds > 0.0 ? plan.seconds : plan.passes, plan.images);
        }
        if (plan.seconds == 0.0) { stops_ = spacedPasses(plan.passes, plan.points, plan.imageMoments); }
    }

    /// False: interrupted.
    bool runSeed(size_t index) {
        VariantSettings settings = result.settings;
        settings.options.seed = plan_.seeds[index];
        auto session = MeasuredSession::start(scene_, settings, host_);
        if (!session) {
            result.problem = session.error().message;
            return true;
        }
        result.curves.push_back({plan_.seeds[index], {}});
        part_ = fmt::format("{}, seed {} of {}", result.variant.name, index + 1, plan_.seeds.size());
        if (host_.onPart) { host_.onPart(part_); }
        const bool byTime = index == 0 && plan_.seconds > 0.0;
        const Outcome outcome = byTime ? runByTime(**session) : runByPasses(**session);
        finishCurve(**session, outcome);
        return outcome != Outcome::Interrupted;
    }

    void finish() {
        result.finalSeeds = finals_.count;
        if (finals_.count == 0) { return; }
        const double values = static_cast<double>(finals_.mean.size());
        for (size_t i = 0; i < finals_.mean.size(); ++i) {
            const double miss = finals_.mean[i] - static_cast<double>(reference_.image.rgb[i]);
            result.finalMeanImageMse += miss * miss / values;
            result.finalVariance += finals_.squares[i] / std::max(1, finals_.count - 1) / values;
        }
    }

    MeasuredVariant result;

  private:
    Outcome runByTime(MeasuredSession& session) {
        const SecondsSchedule schedule(plan_.seconds, plan_.points, plan_.imageMoments);
        Outcome outcome = session.runTo({.passes = 1}, part_);
        double firstPass = 0.0;
        while (outcome == Outcome::Reached) {
            const double now = measure(session);
            stops_.push_back(session.status().passes);
            firstPass = firstPass > 0.0 ? firstPass : now;
            const auto next = schedule.next(firstPass, now);
            if (!next) { break; }
            outcome = session.runTo({.renderSeconds = *next}, part_);
        }
        return outcome;
    }

    Outcome runByPasses(MeasuredSession& session) {
        for (const uint32_t stop : stops_) {
            const StopLimits limits{.passes = stop, .renderSeconds = kMostSlowdown * plan_.seconds};
            const Outcome outcome = session.runTo(limits, part_);
            if (outcome != Outcome::Reached) { return outcome; }
            if (session.status().passes < stop) {
                result.problem =
                    fmt::format("seed {} was given up after {:.0f} s: much slower than the first one",
                                result.curves.back().seed, session.status().renderSeconds);
                break;
            }
            measure(session);
        }
        return Outcome::Reached;
    }

    /// Where noise is taken out, that belongs to the seconds.
    std::shared_ptr<FilmSnapshot> imageOf(const SessionCapture& capture) const {
        const int threads = result.settings.threads;
        auto snapshot = makeSnapshot(capture, {.standardError = result.settings.denoise}, threads);
        if (!result.settings.denoise) { return snapshot; }
        snapshot->aovs = std::make_shared<AovFilm>(capture.aovs);
        const auto began = SessionClock::now();
        auto denoised = denoisedSnapshot(*snapshot, DenoiseQuality::Careful, threads);
        denoised->renderSeconds += secondsSince(began);
        return denoised;
    }

    /// Adds a point to the last curve; returns the film's seconds.
    double measure(MeasuredSession& session) {
        const auto capture = session.capture();
        const auto snapshot = imageOf(*capture);
        ImageF image{snapshot->width, snapshot->height, std::move(snapshot->radiance)};
        MeasuredPoint point{snapshot->passes, snapshot->renderSeconds, evaluate(image)};
        result.curves.back().points.push_back(point);
        if (result.curves.size() == 1) { keep(point, image); }
        last_ = std::move(image);
        return capture->renderSeconds;
    }

    ErrorValues evaluate(const ImageF& image) const {
        MetricOptions options;
        options.exposureStops = plan_.exposureStops;
        ErrorValues values;
        values.fill(std::numeric_limits<double>::quiet_NaN());
        const Result<ImageMetrics> metrics = compareImages(image, reference_.image, options);
        if (!metrics) { return values; }
        at(values, ErrorMeasure::RelativeError) = metrics->rmse / reference_.mean;
        at(values, ErrorMeasure::Mse) = metrics->mse;
        at(values, ErrorMeasure::Rmse) = metrics->rmse;
        at(values, ErrorMeasure::RelMse) = metrics->relMse;
        at(values, ErrorMeasure::RelMseTrimmed) = metrics->relMseTrimmed;
        at(values, ErrorMeasure::Mape) = metrics->mape;
        at(values, ErrorMeasure::Ssim) = metrics->ssim;
        at(values, ErrorMeasure::Flip) = metrics->flip;
        at(values, ErrorMeasure::Bias) = metrics->bias;
        at(values, ErrorMeasure::RelativeBias) = metrics->relativeBias;
        at(values, ErrorMeasure::MseWithoutReference) = metrics->mse - reference_.mse;
        at(values, ErrorMeasure::PictureError) = metrics->pictureError;
        return values;
    }

    /// The first picture at or after each moment; the last point's always.
    void keep(const MeasuredPoint& point, const ImageF& image) {
        const double now = plan_.seconds > 0.0 ? point.seconds : static_cast<double>(point.passes);
        const size_t index = result.curves.back().points.size() - 1;
        if (keptForGood_ < result.images.size()) { result.images.pop_back(); }
        if (moments_.empty()) { return; }
        result.images.push_back({index, image});
        bool due = false;
        while (wanted_ < moments_.size() && now >= moments_[wanted_]) {
            ++wanted_;
            due = true;
        }
        keptForGood_ += due;
    }

    void finishCurve(MeasuredSession& session, Outcome outcome) {
        const SessionStatus status = session.status();
        result.backend = status.backend;
        result.kernel = status.kernel;
        for (int fault = 1; fault < kSampleFaultCount; ++fault) {
            result.droppedSamples += status.faultCounts[static_cast<size_t>(fault)];
        }
        if (outcome == Outcome::Failed) { result.problem = status.error; }
        MeasuredCurve& curve = result.curves.back();
        if (curve.points.empty()) {
            result.curves.pop_back();
        } else if (outcome == Outcome::Reached && curve.points.back().passes == stops_.back()) {
            finals_.add(last_);
        }
    }

    const ConvergencePlan& plan_;
    const SceneDescription& scene_;
    const ReferenceImage& reference_;
    const ConvergenceHost& host_;
    std::string part_;
    std::vector<uint32_t> stops_;  ///< pass counts
    ImageF last_;
    ImageMoments finals_;
    std::vector<double> moments_;  ///< of pictures that are kept
    size_t wanted_ = 0;            ///< moments that have come
    size_t keptForGood_ = 0;       ///< the one after them is the newest, kept until the next
};

}  // namespace

ConvergenceResult runConvergence(const ConvergencePlan& plan, const SceneDescription& scene,
                                 const ReferenceImage& reference, const ConvergenceHost& host) {
    std::vector<VariantRunner> runners;
    for (const ConvergenceVariant& variant : plan.variants) {
        runners.emplace_back(plan, variant, scene, reference, host);
    }
    ConvergenceResult result;
    for (size_t seed = 0; seed < plan.seeds.size() && !result.interrupted; ++seed) {
        for (VariantRunner& runner : runners) {
            if (!runner.result.problem.empty()) { continue; }
            if (!runner.runSeed(seed)) {
                result.interrupted = true;
                break;
            }
        }
    }
    for (VariantRunner& runner : runners) {
        runner.finish();
        result.variants.push_back(std::move(runner.result));
    }
    return result;
}

std::vector<uint32_t> seedsBeside(const std::vector<uint32_t>& taken, uint32_t first, int count) {
    std::vector<uint32_t> seeds;
    for (uint32_t seed = first; static_cast<int>(seeds.size()) < count; ++seed) {
        if (std::ranges::find(taken, seed) == taken.end()) { seeds.push_back(seed); }
    }
    return seeds;
}

}  // namespace glint
