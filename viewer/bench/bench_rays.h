// `glint bench rays`: rays per second of the acceleration structure beside Embree's, and every hit compared.
//
// Primary rays from inside a closed mesh, diffuse bounces from their hits, shadow rays from the bounces' hits
// to a sphere in the middle: all rays stay in the mesh. Both programs get the same rays in the same order on
// the same threads, turn by turn; each figure is the median over the turns.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "engine/base/result.h"

namespace glint {

struct BenchRaysOptions {
    std::string generator = "blob";  ///< a closed mesh around the origin (generated_mesh.h)
    uint32_t triangles = 1'050'000;
    int width = 1024;  ///< width x width primary rays
    int turns = 5;
    int threads = 0;  ///< 0: all
    uint32_t seed = 1;
};

/// Why Glint and Embree may answer differently. All but the last follow from rounding.
enum class RayDisagreement : uint8_t {
    EdgeTie,        ///< neighbouring triangles at the same distance within rounding
    EdgeRounding,   ///< one met, the other missed a triangle whose edge the ray passes within rounding
    EndRounding,    ///< a hit within rounding of the ray's end
    DistanceDrift,  ///< the same triangle, but the distances differ by more than rounding of either allows
    Unexplained,
};
constexpr int kRayDisagreementCount = 5;

struct BenchRaysRow {
    std::string name;
    double glintMraysPerS = 0.0;
    double embreeMraysPerS = 0.0;  ///< 0 without Embree, as everything of Embree's below
    double ratio = 0.0;            ///< Glint over Embree
};

struct BenchRaysReport {
    BenchRaysOptions options;
    uint32_t triangles = 0;
    int threads = 0;
    uint64_t raysCompared = 0;
    bool hasEmbree = false;
    std::string embreeVersion;
    std::vector<BenchRaysRow> rows;
    double glintBuildMtrisPerS = 0.0;
    double embreeBuildMtrisPerS = 0.0;
    double buildRatio = 0.0;
    double bytesPerTriangle = 0.0;  ///< Glint's acceleration structure, without the vertex arrays
    std::array<uint64_t, kRayDisagreementCount> disagreements{};

    uint64_t disagreementCount() const;
};

/// Error: a generator or count that generateMesh() refuses.
Result<BenchRaysReport> measureRays(const BenchRaysOptions& options);

/// For people: a table, the build figures, and each kind of disagreement with its meaning.
std::string benchRaysText(const BenchRaysReport& report);

/// rows[] = {name, glint_mrays_per_s, embree_mrays_per_s, ratio}; build = {glint_mtris_per_s,
/// embree_mtris_per_s, ratio}; disagreements (their sum) and disagreements_by_kind; mesh, triangles, threads,
/// rays, embree (its version or null). Without Embree its figures are null.
nlohmann::ordered_json benchRaysJson(const BenchRaysReport& report);

}  // namespace glint
