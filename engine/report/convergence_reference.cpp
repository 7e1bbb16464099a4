// Replicates by turns in one session: the scene is built once.
#include "engine/report/convergence_reference.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/render/snapshot.h"

namespace glint {
namespace {

/// Mean and spread of replicates, weighted by their passes (West 1979).
class Replicates {
  public:
    void add(const FilmSnapshot& picture) {
        const std::vector<float>& values = picture.radiance;
        if (count_ == 0) {
            mean_.resize(values.size());
            squares_.resize(values.size());
        }
        const double w = picture.passes;
        weight_ += w;
        for (size_t i = 0; i < values.size(); ++i) {
            const double delta = static_cast<double>(values[i]) - mean_[i];
            mean_[i] += delta * w / weight_;
            squares_[i] += w * delta * (static_cast<double>(values[i]) - mean_[i]);
        }
        ++count_;
    }
    int count() const { return count_; }

    void store(ReferencePicture* out) const {
        out->picture.rgb.assign(mean_.begin(), mean_.end());
        out->variance.reserve(squares_.size());
        for (const double sum : squares_) {
            out->variance.push_back(static_cast<float>(sum / weight_ / (count_ - 1)));
        }
    }

  private:
    int count_ = 0;
    double weight_ = 0.0;
    std::vector<double> mean_, squares_;
};

int replicatesOf(IntegratorKind integrator) {
    return integrator == IntegratorKind::Sppm ? kPhotonReplicates : kPathReplicates;
}

void addRemarks(const ReferencePlan& plan, const SessionCapture& last, ReferencePicture* out) {
    if (plan.variant.integrator == IntegratorKind::Sppm) {
        out->remarks.push_back(
            "The reference is by photon mapping: the bias of its finite radius is not in its error bar.");
    }
    if (plan.settings.options.fireflyClamp > 0.0f) {
        out->remarks.push_back(fmt::format("The reference's samples were clamped to {}: it is biased.",
                                           plan.settings.options.fireflyClamp));
    }
    const auto& faults = last.film.faultCounts();
    if (const uint64_t dropped = faults[1] + faults[2] + faults[3]; dropped > 0) {
        out->remarks.push_back(fmt::format(
            "{} samples of the reference's last replicate were not finite or negative and were dropped.",
            dropped));
    }
}

}  // namespace

double ReferencePicture::rmse() const { return std::sqrt(mse); }

double ReferencePicture::relativeError() const { return rmse() / mean; }

void ReferencePicture::summarize() {
    constexpr double kEpsilon = 0.01;  // MetricOptions::relativeEpsilon
    const double count = static_cast<double>(picture.rgb.size());
    mean = mse = relMse = 0.0;
    for (size_t i = 0; i < picture.rgb.size(); ++i) {
        const double value = static_cast<double>(picture.rgb[i]);
        mean += value / count;
        if (knowsItsError()) {
            const double own = static_cast<double>(variance[i]);
            mse += own / count;
            relMse += own / (value * value + kEpsilon) / count;
        }
    }
}

Result<std::optional<ReferencePicture>> makeReference(const ReferencePlan& plan,
                                                      const SceneDescription& scene,
                                                      const ConvergenceHost& host) {
    const int replicates = replicatesOf(plan.variant.integrator);
    VariantSettings settings = plan.settings;
    settings.options.seed = plan.firstSeed;
    auto session = MeasuredSession::start(scene, settings, host);
    if (!session) {
        return session.error();
    }
    // A replicate's own error is the root of R times the mean's.
    StopLimits limits{.renderSeconds = plan.renderSeconds / replicates,
                      .relativeError = plan.relativeError * std::sqrt(static_cast<double>(replicates))};
    ReferencePicture made;
    made.timeLimitSeconds = plan.renderSeconds;
    Replicates sum;
    for (int i = 0; i < replicates; ++i) {
        const std::string part =
            fmt::format("reference by {}, replicate {} of {}", plan.variant.name, i + 1, replicates);
        if (host.onPart) {
            host.onPart(part);
        }
        if (i > 0) {
            (*session)->restartWithSeed(plan.firstSeed + static_cast<uint32_t>(i));
        }
        const auto outcome = (*session)->runTo(limits, part);
        if (outcome == MeasuredSession::Outcome::Failed) {
            return Error{fmt::format("the reference cannot be rendered: {}", (*session)->status().error), {}};
        }
        if (outcome == MeasuredSession::Outcome::Interrupted) {
            break;
        }
        const auto capture = (*session)->capture();
        const auto picture = makeSnapshot(*capture, {}, settings.threads);
        sum.add(*picture);
        made.seeds.push_back(plan.firstSeed + static_cast<uint32_t>(i));
        made.renderSeconds += capture->renderSeconds;
        made.passes += picture->passes;
        if (i == 0) {
            made.endedBy = capture->renderSeconds >= limits.renderSeconds ? "time" : "precision";
        }
        limits = {.passes = picture->passes};
        if (i + 1 == replicates) {
            addRemarks(plan, *capture, &made);
        }
    }
    if (sum.count() < 2) {
        return std::optional<ReferencePicture>();
    }
    made.picture.width = scene.resolution.width;
    made.picture.height = scene.resolution.height;
    sum.store(&made);
    made.method = plan.variant.text;
    made.integrator = plan.variant.integrator;
    made.summarize();
    return std::optional<ReferencePicture>(std::move(made));
}

}  // namespace glint
