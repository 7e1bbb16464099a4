// Long sums: ten million samples with one that outshines all others, and a million passes of the photon
// statistics' recurrence.
//
// The truths are exact: the sums' closed forms, and products of the recurrence's factors as Gamma functions.
#include <cmath>
#include <numbers>
#include <random>

#include "engine/kernels/sppm_gather_kernel.h"
#include "engine/render/film.h"
#include "engine/stress/stress_families.h"
#include "engine/stress/stress_scene.h"

namespace glint {
namespace {

Error stoppedSums() { return {"the stability suite was stopped", {}}; }

/// n - 1 samples of 0.1 and one of `outlier`, after `share` of the others: mean and standard error.
StressCase outlierCase(float outlier, double share, const char* where) {
    StressCase c = namedCase("film", "outlier " + gradeNumber(outlier) + " " + where,
                             "ten million samples of 0.1 and one of " + gradeNumber(outlier) + ", " + where,
                             "exact mean and variance", 1e-9);
    c.run = [=](const StressEffort& effort) -> Result<StressOutcome> {
        const uint32_t count = effort.steps(10000000, 1000000);
        const auto place = static_cast<uint32_t>(share * (count - 1));
        Film film(1, 1);
        std::vector<PixelSample> samples(1);
        for (uint32_t pass = 0; pass < count; ++pass) {
            if (pass % 65536 == 0 && effort.stopped()) { return stoppedSums(); }
            samples[0].radiance = Vec3(pass == place ? outlier : 0.1f);
            film.commit(samples, pass, 1);
        }
        const double n = count;
        const double low = static_cast<double>(0.1f);
        const double step = static_cast<double>(outlier) - low;
        const FilmPixel& pixel = film.pixels()[0];
        StressOutcome outcome;
        outcome.values.push_back({pixel.mean[0], low + step / n, 0.0});
        // The squared deviations of n values of which one lies `step` above the rest sum to step^2 (1 - 1/n).
        outcome.values.push_back({film.standardError(pixel), std::abs(step) / n, 0.0});
        outcome.samples = film.passes();
        outcome.faults = film.faultCounts();
        return outcome;
    };
    return c;
}

double logGammaRatio(double n, double inverseAlpha) {
    return std::lgamma(n + 1.0) + std::lgamma(inverseAlpha) - std::lgamma(n + inverseAlpha);
}

/// m photons in each of n passes: R^2 shrinks by the product of (i + 1) / (i + 1/alpha), which is
/// Gamma(n + 1) Gamma(1/alpha) / Gamma(n + 1/alpha). With equal flux a photon tau / R^2 grows by the sum of
/// m / R_i^2, which telescopes to a closed form, too; it is summed in long double here.
StressCase steadyCase(uint32_t photons, double alpha) {
    StressCase c =
        namedCase("recurrence", gradeNumber(photons) + " photons a pass, alpha " + gradeNumber(alpha),
                  "a million passes with " + gradeNumber(photons) + " photons each", "Gamma functions", 1e-6);
    c.run = [=](const StressEffort& effort) -> Result<StressOutcome> {
        const uint32_t passes = effort.steps(1000000, 100000);
        SppmPixel pixel;
        pixel.radiusSquared = 0.04;
        Gathered gathered;
        gathered.count = photons;
        gathered.flux = Vec3(static_cast<float>(photons) * 0.25f);
        long double fluxOverArea = 0.0L;
        for (uint32_t pass = 0; pass < passes; ++pass) {
            if (pass % 65536 == 0 && effort.stopped()) { return stoppedSums(); }
            fluxOverArea += 0.25L * photons /
                            (0.04L * std::exp(static_cast<long double>(logGammaRatio(pass, 1.0 / alpha))));
            updatePixel(gathered, alpha, pass, 1.0, &pixel);
        }
        const double radius2 = 0.04 * std::exp(logGammaRatio(passes, 1.0 / alpha));
        StressOutcome outcome;
        outcome.values.push_back({pixel.radiusSquared / radius2, 1.0, 0.0});
        outcome.values.push_back(
            {pixel.flux[0] / pixel.radiusSquared / static_cast<double>(fluxOverArea), 1.0, 0.0});
        outcome.values.push_back({pixel.photonCount / (alpha * photons * passes), 1.0, 0.0});
        outcome.samples = passes;
        return outcome;
    };
    return c;
}

/// Nothing for 10,000 passes, then single photons: as if only the passes with photons had been.
StressCase lateCase() {
    StressCase c =
        namedCase("recurrence", "no photon for 10000 passes, then one a pass",
                  "a visible point that no photon finds for 10,000 passes", "Gamma functions", 1e-9);
    c.run = [](const StressEffort&) -> Result<StressOutcome> {
        constexpr double kAlpha = 2.0 / 3.0;
        constexpr uint32_t kEmpty = 10000;
        constexpr uint32_t kLate = 1000;
        SppmPixel pixel;
        pixel.radiusSquared = 0.04;
        Gathered gathered;
        for (uint32_t pass = 0; pass < kEmpty; ++pass) {
            updatePixel(gathered, kAlpha, pass, 1.0, &pixel);
        }
        StressOutcome outcome;
        outcome.values.push_back({1.0 + static_cast<double>(photonRadiance(pixel, kEmpty).x), 1.0, 0.0});
        outcome.values.push_back({pixel.radiusSquared / 0.04, 1.0, 0.0});
        gathered.count = 1;
        gathered.flux = Vec3(0.25f);
        for (uint32_t pass = kEmpty; pass < kEmpty + kLate; ++pass) {
            updatePixel(gathered, kAlpha, pass, 1.0, &pixel);
        }
        const double radius2 = 0.04 * std::exp(logGammaRatio(kLate, 1.0 / kAlpha));
        outcome.values.push_back({pixel.radiusSquared / radius2, 1.0, 0.0});
        outcome.samples = kEmpty + kLate;
        return outcome;
    };
    return c;
}

/// Photons of an even density, Poisson distributed: the estimate is unbiased, and the radius shrinks as
/// n^(alpha - 1) (R^2 ~ Gamma(n + alpha) / Gamma(n + 1) between two late passes; Knaus and Zwicker 2011).
StressCase densityCase(double photonsAtFirst, double alpha) {
    StressCase c = namedCase(
        "recurrence", "even density " + gradeNumber(photonsAtFirst) + ", alpha " + gradeNumber(alpha),
        "a million passes at an even photon density, " + gradeNumber(photonsAtFirst) + " in the first",
        "the asymptotic law and the true radiance", 0.005);
    c.run = [=](const StressEffort& effort) -> Result<StressOutcome> {
        const uint32_t passes = effort.steps(1000000, 20000);
        const uint32_t early = passes / 10;
        const uint32_t runs = effort.steps(32, 24);
        std::vector<double> radiance;
        std::vector<double> shrink;
        for (uint32_t run = 0; run < runs; ++run) {
            std::mt19937_64 random(run);
            SppmPixel pixel;
            pixel.radiusSquared = 1.0;
            double earlyRadius2 = 1.0;
            for (uint32_t pass = 0; pass < passes; ++pass) {
                if (pass % 65536 == 0 && effort.stopped()) { return stoppedSums(); }
                Gathered gathered;
                gathered.count = static_cast<uint32_t>(
                    std::poisson_distribution<int>(photonsAtFirst * pixel.radiusSquared)(random));
                gathered.flux = Vec3(static_cast<float>(gathered.count));
                updatePixel(gathered, alpha, pass, 1.0, &pixel);
                if (pass + 1 == early) { earlyRadius2 = pixel.radiusSquared; }
            }
            radiance.push_back(static_cast<double>(photonRadiance(pixel, passes).x));
            shrink.push_back(pixel.radiusSquared / earlyRadius2);
        }
        const auto valueOf = [&](const std::vector<double>& x, double truth) {
            double mean = 0.0;
            double m2 = 0.0;
            for (const double v : x) {
                mean += v / runs;
            }
            for (const double v : x) {
                m2 += (v - mean) * (v - mean);
            }
            return StressValue{mean / truth, 1.0, std::sqrt(m2 / (runs * (runs - 1.0))) / truth,
                               static_cast<int>(runs) - 1};
        };
        const double law = std::exp(std::lgamma(passes + alpha) - std::lgamma(passes + 1.0) -
                                    std::lgamma(early + alpha) + std::lgamma(early + 1.0));
        StressOutcome outcome;
        outcome.values.push_back(valueOf(radiance, photonsAtFirst / std::numbers::pi));
        outcome.values.push_back(valueOf(shrink, law));
        outcome.samples = uint64_t{passes} * runs;
        return outcome;
    };
    return c;
}

}  // namespace

void addFilmCases(StressCases* cases) {
    cases->push_back(outlierCase(1e3f, 0.5, "in the middle"));
    cases->push_back(outlierCase(1e9f, 0.0, "first"));
    cases->push_back(outlierCase(1e9f, 0.5, "in the middle"));
    cases->push_back(outlierCase(1e9f, 1.0, "last"));
    cases->push_back(outlierCase(3e38f, 0.5, "in the middle"));
    for (size_t i = cases->size() - 5; i < cases->size(); ++i) {
        (*cases)[i].quick = i + 1 == cases->size();
    }
}

void addRecurrenceCases(StressCases* cases) {
    for (const uint32_t photons : {1u, 1000u, 1000000u}) {
        cases->push_back(steadyCase(photons, 2.0 / 3.0));
    }
    cases->push_back(steadyCase(10, 0.1));
    cases->push_back(steadyCase(10, 0.99));
    cases->push_back(lateCase());
    cases->push_back(densityCase(100.0, 2.0 / 3.0));
    cases->push_back(densityCase(1.0, 2.0 / 3.0));
    cases->push_back(densityCase(100.0, 0.9));
}

}  // namespace glint
