// The mean of replicates, and their spread as its error.
#include "engine/report/convergence_reference.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/render/error_estimate.h"
#include "engine/render/integrator.h"
#include "engine/render/snapshot.h"

namespace glint {
namespace {

/// Mean and spread of replicates, weighted by their passes (West 1979).
class Replicates {
  public:
    void add(const FilmSnapshot& image) {
        const std::vector<float>& values = image.radiance;
        if (count_ == 0) {
            mean_.resize(values.size());
            squares_.resize(values.size());
        }
        const double w = image.passes;
        weight_ += w;
        for (size_t i = 0; i < values.size(); ++i) {
            const double delta = static_cast<double>(values[i]) - mean_[i];
            mean_[i] += delta * w / weight_;
            squares_[i] += w * delta * (static_cast<double>(values[i]) - mean_[i]);
        }
        ++count_;
    }
    int count() const { return count_; }

    /// The picture and its figures; needs two.
    void store(ReferenceImage* out) const {
        out->image.rgb.assign(mean_.begin(), mean_.end());
        out->variance.clear();
        for (const double sum : squares_) {
            out->variance.push_back(static_cast<float>(sum / weight_ / (count_ - 1)));
        }
        out->summarize();
    }

  private:
    int count_ = 0;
    double weight_ = 0.0;
    std::vector<double> mean_, squares_;
};

int replicatesOf(IntegratorKind integrator) {
    return integrator == IntegratorKind::Sppm ? kPhotonReplicates : kPathReplicates;
}

uint64_t droppedIn(const Film& film) {
    uint64_t dropped = 0;
    for (int fault = 1; fault < kSampleFaultCount; ++fault) {
        dropped += film.faultCounts()[static_cast<size_t>(fault)];
    }
    return dropped;
}

void addRemarks(const ReferencePlan& plan, uint64_t dropped, ReferenceImage* out) {
    out->remarkBias(plan.settings.options.fireflyClamp);
    if (dropped > 0) {
        out->remarks.push_back(fmt::format(
            "{} samples of the reference were not finite or negative and were dropped.", dropped));
    }
}

/// Replicates by turns in one session: the scene is built once.
class ReferenceMaker {
  public:
    ReferenceMaker(const ReferencePlan& plan, const SceneDescription& scene, const ConvergenceHost& host,
                   MeasuredSession& session)
        : plan_(plan), host_(host), session_(session), planned_(replicatesOf(plan.variant.integrator)) {
        made_.timeLimitSeconds = plan.renderSeconds;
        made_.image.width = scene.resolution.width;
        made_.image.height = scene.resolution.height;
        made_.method = plan.variant.text;
        made_.integrator = plan.variant.integrator;
    }

    Result<std::optional<ReferenceImage>> make() {
        // A replicate's own error is the root of R times the mean's.
        const double errorOfOne = plan_.relativeError * std::sqrt(static_cast<double>(planned_));
        while (wantsMore()) {
            const auto outcome = addReplicate(errorOfOne);
            if (outcome == MeasuredSession::Outcome::Failed) {
                return Error{fmt::format("the reference cannot be rendered: {}", session_.status().error),
                             {}};
            }
            if (outcome == MeasuredSession::Outcome::Interrupted) {
                interrupted_ = true;
                break;
            }
        }
        if (sum_.count() < 2) { return std::optional<ReferenceImage>(); }
        made_.endedBy = isPrecise() ? "precision" : interrupted_ ? "interrupt" : "time";
        if (interrupted_) {
            made_.timeLimitSeconds =
                made_.renderSeconds;  // Not what it could have been: the next run makes a better one.
        }
        addRemarks(plan_, dropped_, &made_);
        return std::optional<ReferenceImage>(std::move(made_));
    }

  private:
    bool isPrecise() const {
        return plan_.relativeError > 0.0 && made_.relativeError() <= plan_.relativeError;
    }

    /// The planned ones always; then more while their spread is too large and another one fits into the time.
    bool wantsMore() const {
        if (sum_.count() < planned_) { return true; }
        const double each = made_.renderSeconds / sum_.count();
        return plan_.relativeError > 0.0 && !isPrecise() && made_.renderSeconds + each <= plan_.renderSeconds;
    }

    /// Until its own estimate says twice that it is as precise as `error`, or its time is up.
    MeasuredSession::Outcome renderFirst(double error, const std::string& part) {
        const double seconds = plan_.renderSeconds / planned_;
        if (!(error > 0.0)) { return session_.runTo({.renderSeconds = seconds}, part); }
        int precise = 0;
        for (uint32_t passes = kLeastPassesForError;; passes += passes / kLeastPassesForError) {
            const auto outcome = session_.runTo({.passes = passes, .renderSeconds = seconds}, part);
            if (outcome != MeasuredSession::Outcome::Reached) { return outcome; }
            const auto capture = session_.capture();
            const ErrorEstimate found =
                estimateRmseOverMean(capture->film, capture->statistics.get(), plan_.settings.threads);
            precise = found.high <= error ? precise + 1 : 0;
            if (precise == 2 || capture->renderSeconds >= seconds) { return outcome; }
        }
    }

    MeasuredSession::Outcome addReplicate(double errorOfOne) {
        const int index = sum_.count();
        const std::string part =
            index < planned_
                ? fmt::format("reference by {}, replicate {} of {}", plan_.variant.name, index + 1, planned_)
                : fmt::format("reference by {}, replicate {}: its error is {:.3g} %, wanted is {:.3g} %",
                              plan_.variant.name, index + 1, 100.0 * made_.relativeError(),
                              100.0 * plan_.relativeError);
        if (host_.onPart) { host_.onPart(part); }
        const uint32_t seed = plan_.firstSeed + static_cast<uint32_t>(index);
        if (index > 0) { session_.restartWithSeed(seed); }
        const auto outcome =
            index == 0 ? renderFirst(errorOfOne, part) : session_.runTo({.passes = passesEach_}, part);
        if (outcome == MeasuredSession::Outcome::Reached) {
            const auto capture = session_.capture();
            const auto image = makeSnapshot(*capture, {}, plan_.settings.threads);
            sum_.add(*image);
            made_.seeds.push_back(seed);
            made_.renderSeconds += capture->renderSeconds;
            made_.passes += image->passes;
            passesEach_ = image->passes;
            dropped_ += droppedIn(capture->film);
            if (sum_.count() >= 2) { sum_.store(&made_); }
        }
        return outcome;
    }

    const ReferencePlan& plan_;
    const ConvergenceHost& host_;
    MeasuredSession& session_;
    int planned_;
    uint32_t passesEach_ = 0;
    uint64_t dropped_ = 0;
    bool interrupted_ = false;
    Replicates sum_;
    ReferenceImage made_;
};

}  // namespace

double ReferenceImage::rmse() const { return std::sqrt(mse); }

double ReferenceImage::relativeError() const { return mse > 0.0 ? rmse() / mean : 0.0; }

void ReferenceImage::remarkBias(float fireflyClamp) {
    if (integrator && integratorType(*integrator).hasBias()) {
        remarks.push_back(fmt::format("The reference is by {}, whose bias is not in its error bar.",
                                      integratorInfo(*integrator).displayName));
    }
    if (fireflyClamp > 0.0f) {
        remarks.push_back(
            fmt::format("The reference's samples were clamped to {}: it is biased.", fireflyClamp));
    }
}

void ReferenceImage::summarize() {
    constexpr double kEpsilon = 0.01;  // MetricOptions::relativeEpsilon
    const double count = static_cast<double>(image.rgb.size());
    mean = mse = relMse = 0.0;
    for (size_t i = 0; i < image.rgb.size(); ++i) {
        const double value = static_cast<double>(image.rgb[i]);
        mean += value / count;
        if (knowsItsError()) {
            const double own = static_cast<double>(variance[i]);
            mse += own / count;
            relMse += own / (value * value + kEpsilon) / count;
        }
    }
}

Result<std::optional<ReferenceImage>> makeReference(const ReferencePlan& plan, const SceneDescription& scene,
                                                    const ConvergenceHost& host) {
    VariantSettings settings = plan.settings;
    settings.options.seed = plan.firstSeed;
    auto session = MeasuredSession::start(scene, settings, host);
    if (!session) { return session.error(); }
    return ReferenceMaker(plan, scene, host, **session).make();
}

}  // namespace glint
