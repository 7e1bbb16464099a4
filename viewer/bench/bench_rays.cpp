// Making the rays, timing both programs in turns, and comparing what they answered.
#include "viewer/bench/bench_rays.h"

#include <algorithm>
#include <optional>

#include "engine/base/parallel.h"
#include "engine/builders/instance_builder.h"
#include "engine/kernels/surface.h"
#include "engine/scene/generated_mesh.h"
#include "viewer/bench/bench_statistics.h"
#include "viewer/bench/embree_oracle.h"
#include "viewer/bench/ray_comparison.h"

namespace glint {
namespace {

constexpr FeatureMask kBenchMask = kFeatureMesh;
constexpr int64_t kChunk = 4096;

double secondsOf(const auto& work) {
    const Stopwatch stopwatch;
    work();
    return stopwatch.seconds();
}

double median(std::vector<double> values) { return percentilesOf(std::move(values)).median; }

/// Uniform numbers in [0, 1) from counters (a finaliser of Steele, Lea and Flood's splitmix64, 2014).
float uniform(uint64_t ray, uint32_t dimension, uint32_t seed) {
    uint64_t z = (ray * 16 + dimension) * 0x9e3779b97f4a7c15ull + seed * 0xd1342543de82ef95ull;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return static_cast<float>((z ^ (z >> 31)) >> 40) * 0x1p-24f;
}

Vec3 uniformSphere(float u, float v) {
    const float z = 1.0f - 2.0f * u;
    const float r = safeSqrt(1.0f - z * z);
    return {r * std::cos(kTwoPi * v), r * std::sin(kTwoPi * v), z};
}

/// The mesh, ready in both programs.
struct Contest {
    std::shared_ptr<const BuiltMesh> mesh;
    std::shared_ptr<const InstanceTable> instances;
    std::optional<EmbreeOracle> embree;
    SceneView view;
};

/// One answer per ray; occlusion rays answer with primitive 0 or kNone.
struct Answers {
    std::vector<Hit> hits;
    explicit Answers(size_t count) : hits(count, Hit{kInfinity, kNone, kNone, Vec2(0.0f)}) {}
};

struct RaySet {
    std::string name;
    bool anyHit = false;
    std::vector<Ray> rays;
};

std::vector<Ray> primaryRays(int width) {
    std::vector<Ray> rays;
    for (int y = 0; y < width; ++y) {
        for (int x = 0; x < width; ++x) {
            const float sx = (2.0f * (static_cast<float>(x) + 0.5f) / static_cast<float>(width) - 1.0f);
            const float sy = (1.0f - 2.0f * (static_cast<float>(y) + 0.5f) / static_cast<float>(width));
            rays.push_back({Vec3(0.05f, 0.02f, 0.1f), Vec3(sx, sy, -1.0f)});
        }
    }
    return rays;
}

/// Calls make(index, surface towards the ray) for every ray that hits.
template <class Make>
std::vector<Ray> raysFromHits(const Contest& contest, const std::vector<Ray>& rays, const Answers& answers,
                              const Make& make) {
    std::vector<Ray> result;
    for (size_t i = 0; i < rays.size(); ++i) {
        if (answers.hits[i].primitive == kNone) { continue; }
        SurfacePoint surface = surfaceAt<kBenchMask>(contest.view, rays[i], answers.hits[i]);
        if (glm::dot(surface.ng, rays[i].direction) > 0.0f) { surface.ng = -surface.ng; }
        result.push_back(make(i, surface));
    }
    return result;
}

void traceGlint(const Contest& contest, const RaySet& set, int threads, Answers* answers) {
    parallelChunks(static_cast<int64_t>(set.rays.size()), kChunk, threads, [&](int64_t begin, int64_t end) {
        for (int64_t i = begin; i < end; ++i) {
            const Ray& ray = set.rays[static_cast<size_t>(i)];
            Hit hit{kInfinity, kNone, kNone, Vec2(0.0f)};
            if (set.anyHit) {
                hit.primitive = occluded<kBenchMask>(contest.view, ray) ? 0 : kNone;
            } else {
                intersect<kBenchMask>(contest.view, ray, &hit);
            }
            answers->hits[static_cast<size_t>(i)] = hit;
        }
    });
}

void traceEmbree(const Contest& contest, const RaySet& set, int threads, Answers* answers) {
    parallelChunks(static_cast<int64_t>(set.rays.size()), kChunk, threads, [&](int64_t begin, int64_t end) {
        for (int64_t i = begin; i < end; ++i) {
            const Ray& ray = set.rays[static_cast<size_t>(i)];
            Hit hit{kInfinity, kNone, kNone, Vec2(0.0f)};
            if (set.anyHit) {
                hit.primitive = contest.embree->occluded(ray) ? 0 : kNone;
            } else {
                contest.embree->intersect(ray, &hit);
            }
            answers->hits[static_cast<size_t>(i)] = hit;
        }
    });
}

/// Times a set in both programs, compares the answers, and returns Glint's.
Answers contestRays(const Contest& contest, const RaySet& set, BenchRaysReport* report) {
    Answers glint(set.rays.size());
    Answers embree(set.rays.size());
    std::vector<double> glintSeconds, embreeSeconds;
    for (int turn = 0; turn < std::max(1, report->options.turns); ++turn) {
        glintSeconds.push_back(secondsOf([&] { traceGlint(contest, set, report->threads, &glint); }));
        if (!contest.embree) { continue; }
        embreeSeconds.push_back(secondsOf([&] { traceEmbree(contest, set, report->threads, &embree); }));
    }
    const double mrays = 1e-6 * static_cast<double>(set.rays.size());
    BenchRaysRow row{set.name, mrays / median(glintSeconds), 0.0, 0.0};
    if (contest.embree) {
        row.embreeMraysPerS = mrays / median(embreeSeconds);
        row.ratio = row.glintMraysPerS / row.embreeMraysPerS;
        report->raysCompared += set.rays.size();
        for (size_t i = 0; i < set.rays.size(); ++i) {
            const auto kind = compareHits(contest.view, *contest.embree, set.rays[i], set.anyHit,
                                          glint.hits[i], embree.hits[i]);
            if (kind) { ++report->disagreements[static_cast<size_t>(*kind)]; }
        }
    }
    report->rows.push_back(row);
    return glint;
}

/// Builds in turns and keeps the last of each.
void contestBuilds(std::shared_ptr<const MeshData> data, Contest* contest, BenchRaysReport* report) {
    std::vector<double> glintSeconds, embreeSeconds;
    for (int turn = 0; turn < std::min(3, std::max(1, report->options.turns)); ++turn) {
        contest->mesh.reset();
        glintSeconds.push_back(secondsOf([&] { contest->mesh = buildMesh(data, report->threads); }));
        if (!EmbreeOracle::available()) { continue; }
        contest->embree.reset();
        contest->embree.emplace(data, report->threads);
        embreeSeconds.push_back(contest->embree->buildSeconds());
    }
    const double mtris = 1e-6 * report->triangles;
    report->glintBuildMtrisPerS = mtris / median(glintSeconds);
    report->bytesPerTriangle = static_cast<double>(contest->mesh->accelerationBytes()) / report->triangles;
    if (embreeSeconds.empty()) { return; }
    report->embreeBuildMtrisPerS = mtris / median(embreeSeconds);
    report->buildRatio = report->glintBuildMtrisPerS / report->embreeBuildMtrisPerS;
}

}  // namespace

uint64_t BenchRaysReport::disagreementCount() const {
    uint64_t sum = 0;
    for (uint64_t count : disagreements) {
        sum += count;
    }
    return sum;
}

Result<BenchRaysReport> measureRays(const BenchRaysOptions& options) {
    const MeshGenerator source{
        .name = options.generator, .triangles = options.triangles, .seed = options.seed};
    auto data = generateMesh(source);
    if (!data) { return data.error(); }

    BenchRaysReport report;
    report.options = options;
    report.triangles = (*data)->triangleCount();
    report.threads = options.threads > 0 ? options.threads : defaultThreadCount();
    report.hasEmbree = EmbreeOracle::available();
    report.embreeVersion = EmbreeOracle::version();

    Contest contest;
    contestBuilds(*data, &contest, &report);
    SceneDescription scene;
    scene.materials.resize(1);
    scene.objects.resize(1);
    scene.objects[0].shape = ShapeKind::Mesh;
    scene.objects[0].mesh = 0;
    contest.instances = buildInstances(scene, {contest.mesh}, {});
    contest.view.geometry = contest.instances->view();

    RaySet primary{"primary", false, primaryRays(std::max(1, options.width))};
    const Answers primaryAnswers = contestRays(contest, primary, &report);
    RaySet diffuse{"diffuse", false, {}};
    diffuse.rays =
        raysFromHits(contest, primary.rays, primaryAnswers, [&](size_t i, const SurfacePoint& surface) {
            const Vec3 w =
                surface.ng + uniformSphere(uniform(i, 0, options.seed), uniform(i, 1, options.seed));
            return spawnRay(surface, isZero(w) ? surface.ng : glm::normalize(w));
        });
    const Answers diffuseAnswers = contestRays(contest, diffuse, &report);
    RaySet shadow{"shadow", true, {}};
    shadow.rays =
        raysFromHits(contest, diffuse.rays, diffuseAnswers, [&](size_t i, const SurfacePoint& surface) {
            const Vec3 n = uniformSphere(uniform(i, 2, options.seed), uniform(i, 3, options.seed));
            return spawnShadowRay(surface, Vec3(0.2f, 0.3f, 0.0f) + 0.3f * n, Vec3(0.0f), Vec3(0.0f));
        });
    contestRays(contest, shadow, &report);
    return report;
}

}  // namespace glint
