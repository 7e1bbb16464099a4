// Errors are the estimates of error_estimate.h: there is no reference yet.
#include "engine/report/convergence_pilot.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "engine/render/error_estimate.h"

namespace glint {
namespace {

using Outcome = MeasuredSession::Outcome;

/// Estimates from few passes are mostly too large.
constexpr double kPessimism = 0.75;
/// An error bar needs two passes.
constexpr uint32_t kLeastPasses = 2;

struct PilotPoint {
    double work = 0.0;  ///< seconds or passes
    double error = 0.0;
};

class Pilot {
  public:
    Pilot(const ConvergencePlan& plan, MeasuredSession& session, double mostSeconds, int threads)
        : plan_(plan), session_(session), mostSeconds_(mostSeconds), threads_(threads) {}

    /// The error at the plan's end; nothing: not known.
    std::optional<double> predict() {
        const auto first = pointAt(0.5);
        const auto second = first ? pointAt(1.0) : first;
        if (!second || !std::isfinite(second->error) || !(second->error > 0.0)) { return std::nullopt; }
        double slope = 0.5;
        if (std::isfinite(first->error) && second->work > first->work) {
            slope = std::log(first->error / second->error) / std::log(second->work / first->work);
        }
        const double whole = plan_.seconds > 0.0 ? plan_.seconds : plan_.passes;
        return second->error * std::pow(std::min(1.0, second->work / whole), std::clamp(slope, 0.5, 1.0));
    }

  private:
    /// After that share of the plan, or of what the pilot may take.
    std::optional<PilotPoint> pointAt(double share) {
        const bool byTime = plan_.seconds > 0.0;
        Outcome outcome = session_.runTo({.passes = kLeastPasses});
        if (outcome == Outcome::Reached) {
            const auto passes = static_cast<uint32_t>(std::ceil(share * plan_.passes));
            const double seconds = share * (byTime ? std::min(plan_.seconds, mostSeconds_) : mostSeconds_);
            outcome = session_.runTo({.passes = byTime ? 0 : passes, .renderSeconds = seconds});
        }
        const auto capture = outcome == Outcome::Reached ? session_.capture() : std::nullopt;
        if (!capture) { return std::nullopt; }
        return PilotPoint{
            byTime ? capture->renderSeconds : static_cast<double>(capture->film.passes()),
            kPessimism * estimateRmseOverMean(capture->film, capture->statistics.get(), threads_).low};
    }

    const ConvergencePlan& plan_;
    MeasuredSession& session_;
    double mostSeconds_;
    int threads_;
};

}  // namespace

double predictSmallestError(const ConvergencePlan& plan, const SceneDescription& scene, double mostSeconds,
                            const ConvergenceHost& host) {
    double smallest = 0.0;
    for (const ConvergenceVariant& variant : plan.variants) {
        VariantSettings settings = variant.applyTo(plan.defaults);
        settings.options.seed = plan.seeds[0];
        auto session = MeasuredSession::start(scene, settings, host);
        if (!session) { continue; }
        if (host.onPart) { host.onPart(fmt::format("pilot of {}", variant.name)); }
        if (const auto error = Pilot(plan, **session, mostSeconds, settings.threads).predict()) {
            smallest = smallest > 0.0 ? std::min(smallest, *error) : *error;
        }
    }
    return smallest;
}

}  // namespace glint
