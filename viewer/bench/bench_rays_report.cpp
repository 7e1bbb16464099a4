// `glint bench rays` in words and in JSON.
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "viewer/bench/bench_rays.h"

namespace glint {
namespace {

struct KindText {
    const char* key;
    const char* meaning;
};
constexpr KindText kRayKinds[kRayDisagreementCount] = {
    {"edge_tie", "neighbouring triangles at the same distance within rounding"},
    {"edge_rounding", "a triangle's edge passed within rounding, met by one only"},
    {"end_rounding", "a hit within rounding of the ray's end"},
    {"distance_drift", "the same triangle, distances apart by more than rounding"},
    {"unexplained", "no rounding explains it"},
};

std::string embreeColumns(const BenchRaysReport& report, double embree, double ratio) {
    return report.hasEmbree ? fmt::format("{:>10.2f}{:>8.2f}", embree, ratio) : std::string();
}

}  // namespace

std::string benchRaysText(const BenchRaysReport& r) {
    std::string out = fmt::format("{} triangles (\"{}\"), {} thread{}; median of {} turns\n", r.triangles,
                                  r.options.generator, r.threads, r.threads == 1 ? "" : "s", r.options.turns);
    if (r.hasEmbree) {
        out += fmt::format(
            "Embree {}: high-quality build, RTC_SCENE_FLAG_ROBUST, rtcIntersect1 and rtcOccluded1\n",
            r.embreeVersion);
    } else {
        out += "Embree was not found when Glint was compiled: Glint's figures alone\n";
    }
    out += fmt::format("\n{:<22}{:>10}{}\n", "", "Glint", r.hasEmbree ? "    Embree   ratio" : "");
    for (const BenchRaysRow& row : r.rows) {
        out += fmt::format("{:<22}{:>10.2f}{}\n", row.name + ", Mrays/s", row.glintMraysPerS,
                           embreeColumns(r, row.embreeMraysPerS, row.ratio));
    }
    out += fmt::format("{:<22}{:>10.2f}{}\n", "build, Mtriangles/s", r.glintBuildMtrisPerS,
                       embreeColumns(r, r.embreeBuildMtrisPerS, r.buildRatio));
    out += fmt::format("{:<22}{:>10.1f}\n", "bytes per triangle", r.bytesPerTriangle);
    if (!r.hasEmbree) { return out; }
    out += fmt::format("\n{} of {} answers differ from Embree's\n", r.disagreementCount(), r.raysCompared);
    for (size_t i = 0; i < kRayDisagreementCount; ++i) {
        if (r.disagreements[i] > 0) {
            out += fmt::format("{:>10}  {}\n", r.disagreements[i], kRayKinds[i].meaning);
        }
    }
    return out;
}

nlohmann::ordered_json benchRaysJson(const BenchRaysReport& r) {
    using Json = nlohmann::ordered_json;
    const auto orNull = [&](double x) { return r.hasEmbree ? Json(x) : Json(nullptr); };
    Json out;
    out["mesh"] = r.options.generator;
    out["triangles"] = r.triangles;
    out["threads"] = r.threads;
    out["turns"] = r.options.turns;
    out["embree"] = r.hasEmbree ? Json(r.embreeVersion) : Json(nullptr);
    out["embree_robust"] = r.hasEmbree ? Json(true) : Json(nullptr);
    out["rows"] = Json::array();
    for (const BenchRaysRow& row : r.rows) {
        out["rows"].push_back({{"name", row.name},
                               {"glint_mrays_per_s", row.glintMraysPerS},
                               {"embree_mrays_per_s", orNull(row.embreeMraysPerS)},
                               {"ratio", orNull(row.ratio)}});
    }
    out["build"] = {{"glint_mtris_per_s", r.glintBuildMtrisPerS},
                    {"embree_mtris_per_s", orNull(r.embreeBuildMtrisPerS)},
                    {"ratio", orNull(r.buildRatio)},
                    {"bytes_per_triangle", r.bytesPerTriangle}};
    out["rays"] = r.raysCompared;
    out["disagreements"] = r.hasEmbree ? Json(r.disagreementCount()) : Json(nullptr);
    for (size_t i = 0; r.hasEmbree && i < kRayDisagreementCount; ++i) {
        out["disagreements_by_kind"][kRayKinds[i].key] = r.disagreements[i];
    }
    return out;
}

}  // namespace glint
