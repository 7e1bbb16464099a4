#include "engine/stress/stress_suite.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "engine/base/nearest_name.h"
#include "engine/base/thread_limit.h"
#include "engine/stress/stress_families.h"

namespace glint {
namespace {

std::vector<std::string_view> familyNames(const std::vector<StressCase>& cases) {
    std::vector<std::string_view> names;
    for (const StressCase& c : cases) {
        if (names.empty() || names.back() != c.family) { names.push_back(c.family); }
    }
    return names;
}

std::string joined(const std::vector<std::string_view>& names) {
    std::string text;
    for (const std::string_view name : names) {
        if (!text.empty()) { text += ", "; }
        text += name;
    }
    return text;
}

}  // namespace

std::string_view stressFamilyAbout(std::string_view family) {
    constexpr std::pair<std::string_view, std::string_view> kAbout[] = {
        {"scale", "units of length from 1e-18 to 1e18"},
        {"offset", "up to 1e6 times its size from the origin"},
        {"needles", "aspect up to 1e7"},
        {"degenerate", "triangles without area, or twice"},
        {"coplanar", "sheets down to 1e-8 apart, overlapping faces"},
        {"ratio", "a ground up to 1e7 times as large as what stands on it"},
        {"roughness", "GGX alpha 1e-4 to 1"},
        {"grazing", "down to 1e-6 radians from along the surface"},
        {"lamp", "size 1e-12 to 1e6, radiance to 1e30, touching, ellipsoids, narrow spots"},
        {"glass", "index 1 to 4, nested, touching, critical angle"},
        {"albedo", "walls of 0.9 to 1, up to 10000 bounces"},
        {"camera", "aperture 0 to 1e6, focus from 1e-6, field of view 1e-4 to 179.9 degrees"},
        {"environment", "one pixel of up to 1e30"},
        {"instances", "scaled 1e-6 to 1e6, sheared, mirrored"},
        {"photons", "radius 1e-6 to 1e12 of the floor, 1 to 1e7 photons, other units, far away"},
        {"recurrence", "a million passes of SPPM's update"},
        {"revolved", "turned profiles with rays along, across and beside them, sizes 1e-12 to 1e12"},
        {"film", "ten million samples with an outlier"},
    };
    for (const auto& [name, about] : kAbout) {
        if (name == family) { return about; }
    }
    return {};
}

std::vector<StressCase> stressCases() {
    StressCases cases;
    addScaleCases(&cases);
    addOffsetCases(&cases);
    addNeedleCases(&cases);
    addMeshCases(&cases);
    addGlossCases(&cases);
    addEmitterCases(&cases);
    addGlassCases(&cases);
    addAlbedoCases(&cases);
    addCameraCases(&cases);
    addEnvironmentCases(&cases);
    addInstanceCases(&cases);
    addPhotonCases(&cases);
    addRevolvedCases(&cases);
    addRecurrenceCases(&cases);
    addFilmCases(&cases);
    return cases;
}

Result<std::vector<StressCase>> filterStressCases(const std::vector<StressCase>& cases,
                                                  const std::string& filter) {
    const std::vector<std::string_view> families = familyNames(cases);
    const bool isFamily = std::ranges::find(families, filter) != families.end();
    std::vector<StressCase> chosen;
    for (const StressCase& c : cases) {
        const bool meant =
            isFamily ? c.family == filter : (c.family + "/" + c.grade).find(filter) != std::string::npos;
        if (meant) { chosen.push_back(c); }
    }
    if (!chosen.empty()) { return chosen; }
    return Error{fmt::format("no case is called '{}'{}; families are {}", filter,
                             didYouMean(filter, families), joined(families)),
                 {}};
}

Result<StressResult> runStressCase(const StressCase& stressCase, const StressEffort& effort) {
    StressResult result;
    result.stressCase = &stressCase;
    const auto began = std::chrono::steady_clock::now();
    const Result<StressOutcome> outcome = stressCase.run(effort);
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    if (!outcome && effort.stopped()) { return outcome.error(); }
    if (outcome) {
        result.outcome = *outcome;
        result.judgement = judgeStress(*outcome, stressCase.tolerance);
    } else {
        result.judgement = judgeStress({}, stressCase.tolerance);
        result.judgement.reason = outcome.error().message;
    }
    return result;
}

Status runStressCases(const std::vector<StressCase>& cases, const StressEffort& effort,
                      const std::function<void(StressResult)>& onResult) {
    StressEffort single = effort;
    single.threads = 1;
    std::vector<std::optional<StressResult>> results(cases.size());
    std::mutex mutex;
    std::atomic<size_t> next{0};
    size_t handedOut = 0;
    Status status;
    const auto work = [&] {
        for (size_t i = next++; i < cases.size(); i = next++) {
            Result<StressResult> result = runStressCase(cases[i], single);
            const std::lock_guard lock(mutex);
            if (!result) {
                status = result.error();
                return;
            }
            results[i] = std::move(*result);
            for (; handedOut < results.size() && results[handedOut]; ++handedOut) {
                onResult(std::move(*results[handedOut]));
            }
        }
    };
    {
        std::vector<std::jthread> threads;
        const int count = startableThreads(effort.threads);
        threads.reserve(static_cast<size_t>(count));
        for (int i = 0; i < count; ++i) {
            threads.emplace_back(work);
        }
    }
    return status;
}

}  // namespace glint
