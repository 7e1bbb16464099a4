// `glint bench revolve`: rays against surfaces of revolution beside the same surfaces as triangles, fine
// enough that their silhouettes are off by a ten-thousandth of their size, by turns in one run.
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "engine/base/parallel.h"
#include "engine/builders/profile_builder.h"
#include "engine/builders/scene_builder.h"
#include "engine/kernels/intersect.h"
#include "engine/kernels/surface.h"
#include "engine/math/rng.h"
#include "engine/scene/profile.h"
#include "engine/scene/scene_building.h"
#include "viewer/bench/bench.h"
#include "viewer/bench/bench_pairs.h"
#include "viewer/bench/bench_statistics.h"

namespace glint {
namespace {

constexpr double kSilhouetteError = 1e-4;  // of the surface's size
constexpr int kRays = 1 << 18;
constexpr FeatureMask kCurves = kFeatureRevolved;
constexpr FeatureMask kTriangles = kFeatureMesh;

struct Profile {
    const char* name;
    CurveKind curve;
    int degree;
    std::vector<Vec2> points;
};

std::vector<Profile> profiles() {
    return {{"cone", CurveKind::Bezier, 1, {{0.5f, 0.0f}, {0.1f, 1.0f}}},
            {"vase",
             CurveKind::Bezier,
             3,
             {{0.0f, 0.0f},
              {0.4f, 0.0f},
              {0.6f, 0.3f},
              {0.3f, 0.6f},
              {0.15f, 0.75f},
              {0.25f, 0.9f},
              {0.35f, 1.0f}}},
            {"wave of degree 9",
             CurveKind::Bezier,
             9,
             {{0.0f, 0.0f},
              {0.9f, 0.05f},
              {0.1f, 0.2f},
              {0.8f, 0.3f},
              {0.0f, 0.45f},
              {0.8f, 0.55f},
              {0.1f, 0.7f},
              {0.7f, 0.8f},
              {0.5f, 0.9f},
              {0.0f, 1.0f}}},
            {"glass",
             CurveKind::Bspline,
             3,
             {{0.0f, 0.0f},
              {0.0f, 0.0f},
              {0.0f, 0.0f},
              {0.18f, 0.0f},
              {0.18f, 0.02f},
              {0.03f, 0.05f},
              {0.02f, 0.3f},
              {0.03f, 0.45f},
              {0.2f, 0.6f},
              {0.22f, 0.8f},
              {0.17f, 1.0f},
              {0.16f, 1.0f},
              {0.21f, 0.8f},
              {0.19f, 0.61f},
              {0.0f, 0.47f},
              {0.0f, 0.47f},
              {0.0f, 0.47f}}}};
}

/// The profile as a polygon that stays within `error` of it.
std::vector<Vec2> polygonOf(const std::vector<ProfileCurve>& curves, double error) {
    std::vector<Vec2> polygon;
    for (const ProfileCurve& curve : curves) {
        const auto at = [&](double s) {
            return glm::dvec2(evaluateBernstein<kMaxProfileDegree>(curve.x, curve.degree, s).value,
                              evaluateBernstein<kMaxProfileDegree>(curve.y, curve.degree, s).value);
        };
        int parts = 1;
        const auto farthest = [&] {
            double most = 0.0;
            for (int i = 0; i < parts; ++i) {
                const double a = static_cast<double>(i) / parts, b = (i + 1.0) / parts;
                most = std::max(most, glm::length(at(0.5 * (a + b)) - 0.5 * (at(a) + at(b))));
            }
            return most;
        };
        while (farthest() > error) {
            parts += 1 + parts / 4;
        }
        for (int i = polygon.empty() ? 0 : 1; i <= parts; ++i) {
            polygon.emplace_back(at(static_cast<double>(i) / parts));
        }
    }
    return polygon;
}

MeshData trianglesOf(const std::vector<Vec2>& polygon, int sides) {
    MeshData mesh;
    for (const Vec2& point : polygon) {
        for (int i = 0; i < sides; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / sides;
            mesh.positions.emplace_back(static_cast<double>(point.x) * std::cos(angle),
                                        static_cast<double>(point.y),
                                        -static_cast<double>(point.x) * std::sin(angle));
        }
    }
    const auto vertex = [&](size_t ring, int side) {
        return static_cast<uint32_t>(ring * static_cast<size_t>(sides) + static_cast<size_t>(side % sides));
    };
    for (size_t ring = 0; ring + 1 < polygon.size(); ++ring) {
        for (int i = 0; i < sides; ++i) {
            const uint32_t a = vertex(ring, i), b = vertex(ring, i + 1);
            const uint32_t c = vertex(ring + 1, i + 1), d = vertex(ring + 1, i);
            if (polygon[ring].x != 0.0f) { mesh.indices.insert(mesh.indices.end(), {a, b, c}); }
            if (polygon[ring + 1].x != 0.0f) { mesh.indices.insert(mesh.indices.end(), {a, c, d}); }
        }
    }
    return mesh;
}

/// Through the surface's box, from a sphere around it.
std::vector<Ray> raysThrough(const Bounds& box) {
    std::vector<Ray> rays;
    uint64_t counter = 0;
    const auto next = [&] { return uniformFloat(static_cast<uint32_t>(hashCounter(1, ++counter) >> 32)); };
    for (int i = 0; i < kRays; ++i) {
        const Vec3 to = box.lo + Vec3(next(), next(), next()) * box.extent();
        const float z = 2.0f * next() - 1.0f, angle = kTwoPi * next();
        const float ring = std::sqrt(1.0f - z * z);
        const Vec3 from = box.center() +
                          glm::length(box.extent()) * Vec3(ring * std::cos(angle), z, ring * std::sin(angle));
        rays.push_back({from, glm::normalize(to - from)});
    }
    return rays;
}

template <FeatureMask kMask>
double secondsOf(const SceneView& view, const std::vector<Ray>& rays, int threads, int64_t* hits) {
    std::atomic<int64_t> found{0};
    const Stopwatch stopwatch;
    parallelChunks(static_cast<int64_t>(rays.size()), 4096, threads, [&](int64_t begin, int64_t end) {
        int64_t mine = 0;
        for (int64_t i = begin; i < end; ++i) {
            Hit hit;
            mine += intersect<kMask>(view, rays[static_cast<size_t>(i)], &hit) ? 1 : 0;
        }
        found += mine;
    });
    *hits = found;
    return stopwatch.seconds();
}

struct Row {
    std::string name;
    uint32_t triangles = 0;
    double newtonStepsPerRay = 0.0, piecesPerRay = 0.0;
    double hitShare = 0.0, hitDifference = 0.0;  ///< of the rays; of the triangles from the curves
    double mraysPerS = 0.0, meshMraysPerS = 0.0;
    RatioInterval ratio{};  ///< rays per second over the triangles'
};

Result<Row> measureProfile(const Profile& profile, const BenchOptions& options) {
    SceneDescription turned = emptyScene({0, 0, 5}, {0, 0, 0}, 40.0f, 8);
    const size_t index = addObject(&turned, ShapeKind::Revolved, Affine{}, diffuseMaterial(0.5f));
    turned.objects[index].curve = profile.curve;
    turned.objects[index].curveDegree = profile.degree;
    turned.objects[index].profile = profile.points;
    ProfileTable table;
    addProfile(turned.objects[index], &table);
    const ProfileView profileView = table.view(0);
    const Bounds box = profileBounds(profile.points);
    const double error = kSilhouetteError * profileView.data->size();
    const double widest = static_cast<double>(std::max(box.hi.x, -box.lo.x));
    const int sides = static_cast<int>(std::ceil(std::numbers::pi / std::acos(1.0 - error / widest)));
    SceneDescription facetted = emptyScene({0, 0, 5}, {0, 0, 0}, 40.0f, 8);
    MeshData mesh = trianglesOf(polygonOf(table.curves, error), sides);
    Row row{.name = profile.name, .triangles = static_cast<uint32_t>(mesh.triangleCount())};
    addMeshObject(&facetted, std::move(mesh), Affine{}, diffuseMaterial(0.5f));
    const auto build = [&](const SceneDescription& scene) {
        return buildScene({std::make_shared<SceneDescription>(scene), EditKind::Everything}, nullptr,
                          options.threads, nullptr, nullptr);
    };
    const auto first = build(turned), second = build(facetted);
    if (!first) { return first.error(); }
    if (!second) { return second.error(); }
    const std::vector<Ray> rays = raysThrough(box);
    int64_t hits = 0, meshHits = 0;
    const PairTimes times = measureByTurns(
        options.turns,
        [&](uint32_t) { return secondsOf<kCurves>((*first)->view(), rays, options.threads, &hits); },
        [&](uint32_t) { return secondsOf<kTriangles>((*second)->view(), rays, options.threads, &meshHits); });
    TestCounts tests;
    for (const Ray& ray : rays) {
        Hit hit;
        RevolvedShape::intersect<false, false>(profileView, ray, &hit, CountTests{&tests});
    }
    constexpr double kCount = kRays;
    row.newtonStepsPerRay = tests.newtonSteps / kCount;
    row.piecesPerRay = tests.primitives / kCount;
    row.hitShare = static_cast<double>(hits) / kCount;
    row.hitDifference = static_cast<double>(meshHits - hits) / kCount;
    row.mraysPerS = 1e-6 * kCount / percentilesOf(times.first).median;
    row.meshMraysPerS = 1e-6 * kCount / percentilesOf(times.second).median;
    row.ratio = ratioOf(times.second, times.first);
    return row;
}

Result<BenchReport> measureRevolved(const BenchSubject& subject) {
    BenchReport report;
    report.text = "profile            pieces a ray   Newton steps   Mrays/s   triangles   Mrays/s   ratio\n";
    report.json = {{"threads", subject.options.threads},
                   {"turns", subject.options.turns},
                   {"silhouette_error", kSilhouetteError},
                   {"rows", nlohmann::ordered_json::array()}};
    for (const Profile& profile : profiles()) {
        const Result<Row> row = measureProfile(profile, subject.options);
        if (!row) { return row.error(); }
        report.text += fmt::format("{:<18} {:>12.2f} {:>14.2f} {:>9.2f} {:>11} {:>9.2f}   {}\n", row->name,
                                   row->piecesPerRay, row->newtonStepsPerRay, row->mraysPerS, row->triangles,
                                   row->meshMraysPerS, ratioText(row->ratio));
        report.json["rows"].push_back({{"name", row->name},
                                       {"pieces_per_ray", row->piecesPerRay},
                                       {"newton_steps_per_ray", row->newtonStepsPerRay},
                                       {"hit_share", row->hitShare},
                                       {"hit_share_difference", row->hitDifference},
                                       {"mrays_per_s", row->mraysPerS},
                                       {"triangles", row->triangles},
                                       {"triangles_mrays_per_s", row->meshMraysPerS},
                                       {"ratio", ratioJson(row->ratio)}});
        // Silhouettes agree to a ten-thousandth; more says that one of the two is wrong.
        report.isWrong = report.isWrong || std::fabs(row->hitDifference) > 2e-3;
    }
    return report;
}

}  // namespace

Benchmark revolveBenchmark() {
    return {.name = "revolve",
            .about = "Surfaces of revolution beside triangles of the same silhouette",
            .defaults = {.turns = 9},
            .options = {turnsOption("Measurements of each"), threadsOption()},
            .scene = nullptr,
            .measure = measureRevolved};
}

}  // namespace glint
