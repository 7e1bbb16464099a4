#include "engine/report/convergence_summary.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glint {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

Spread spreadOf(const std::vector<double>& values) {
    Spread spread{0.0, kUnknown};
    const double n = static_cast<double>(values.size());
    for (const double value : values) {
        spread.mean += value / n;
    }
    if (values.size() > 1) {
        double squares = 0.0;
        for (const double value : values) {
            squares += (value - spread.mean) * (value - spread.mean);
        }
        spread.deviation = std::sqrt(squares / (n - 1.0));
    }
    return spread;
}

template <class ValueOf>
Spread spreadAt(const MeasuredVariant& variant, size_t point, ValueOf valueOf) {
    std::vector<double> values;
    for (const MeasuredCurve& curve : variant.curves) {
        if (point < curve.points.size()) { values.push_back(valueOf(curve.points[point])); }
    }
    return spreadOf(values);
}

SummaryPoint summarizePoint(const MeasuredVariant& variant, size_t point) {
    SummaryPoint out;
    for (const MeasuredCurve& curve : variant.curves) {
        if (point < curve.points.size()) {
            out.passes = curve.points[point].passes;
            ++out.seeds;
        }
    }
    out.seconds = spreadAt(variant, point, [](const MeasuredPoint& p) { return p.seconds; });
    for (size_t m = 0; m < kErrorMeasureCount; ++m) {
        out.errors[m] = spreadAt(variant, point, [m](const MeasuredPoint& p) { return p.errors[m]; });
    }
    return out;
}

class Summarizer {
  public:
    Summarizer(const ReferenceImage& reference, bool withoutReference)
        : reference_(reference), withoutReference_(withoutReference) {}

    VariantSummary summarize(const MeasuredVariant& variant) const {
        VariantSummary out;
        size_t count = 0;
        for (const MeasuredCurve& curve : variant.curves) {
            count = std::max(count, curve.points.size());
        }
        for (size_t i = 0; i < count; ++i) {
            out.points.push_back(summarizePoint(variant, i));
            out.curve.push_back(
                {out.points.back().seconds.mean,
                 spreadAt(variant, i, [this](const MeasuredPoint& p) { return errorOf(p); }).mean});
        }
        fit(variant, &out);
        for (size_t i = 0; i < kTargetErrors.size(); ++i) {
            out.targets[i] = timeToReach(out.curve, kTargetErrors[i], out.fit);
        }
        out.sameMethodAsReference = reference_.integrator == variant.variant.integrator;
        finalFigures(variant, &out);
        return out;
    }

  private:
    double errorOf(const MeasuredPoint& point) const {
        const double mse = withoutReference_
                               ? std::max(0.0, at(point.errors, ErrorMeasure::MseWithoutReference))
                               : at(point.errors, ErrorMeasure::Mse);
        return std::sqrt(mse) / reference_.mean;
    }

    static double fitBegin(const std::vector<CurvePoint>& curve) {
        if (curve.empty()) { return 0.0; }
        const double begin = curve.back().seconds / kFitTimeRange;
        const auto inside =
            std::ranges::count_if(curve, [&](const CurvePoint& point) { return point.seconds >= begin; });
        return inside >= kFewestFitPoints ? begin : curve.front().seconds;
    }

    void fit(const MeasuredVariant& variant, VariantSummary* out) const {
        out->fitFromSeconds = fitBegin(out->curve);
        std::vector<std::vector<CurvePoint>> curves;
        for (const MeasuredCurve& measured : variant.curves) {
            curves.emplace_back();
            // By the mean's seconds, so that all seeds have the same points.
            for (size_t i = 0; i < measured.points.size(); ++i) {
                const MeasuredPoint& point = measured.points[i];
                if (out->curve[i].seconds < out->fitFromSeconds) { continue; }
                if (at(point.errors, ErrorMeasure::Mse) >= kFitMargin * reference_.mse) {
                    curves.back().push_back({point.seconds, errorOf(point)});
                } else {
                    ++out->leftOutOfFit;
                }
            }
        }
        out->fit = fitLogLog(curves);
    }

    void finalFigures(const MeasuredVariant& variant, VariantSummary* out) const {
        out->variance = out->biasSquared = out->efficiency = out->relativeEfficiency = kUnknown;
        if (variant.finalSeeds < 2) { return; }
        out->variance = variant.finalVariance;
        out->biasSquared =
            variant.finalMeanImageMse - variant.finalVariance / variant.finalSeeds - reference_.mse;
        out->efficiency = 1.0 / (variant.finalVariance * out->points.back().seconds.mean);
    }

    const ReferenceImage& reference_;
    bool withoutReference_;
};

}  // namespace

ConvergenceSummary summarizeConvergence(const ConvergenceResult& result, const ReferenceImage& reference,
                                        bool withoutReference) {
    ConvergenceSummary summary;
    summary.withoutReference = withoutReference && reference.knowsItsError();
    summary.floor = reference.knowsItsError() ? reference.relativeError() : kUnknown;
    summary.smallestError = kUnknown;
    const Summarizer summarizer(reference, summary.withoutReference);
    for (const MeasuredVariant& variant : result.variants) {
        summary.variants.push_back(summarizer.summarize(variant));
        VariantSummary& added = summary.variants.back();
        added.relativeEfficiency = added.efficiency / summary.variants.front().efficiency;
        for (const SummaryPoint& point : added.points) {
            summary.smallestError = std::fmin(
                summary.smallestError, point.errors[static_cast<size_t>(ErrorMeasure::RelativeError)].mean);
        }
    }
    summary.floorRatio = summary.floor / summary.smallestError;
    return summary;
}

}  // namespace glint
