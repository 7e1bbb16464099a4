// `glint bench load`: from an OBJ file to the first picture, stage by stage. The file is written first, and
// read back while it is still in the system's cache: the disk is not what is measured.
#include <cstdio>
#include <filesystem>

#include <fmt/format.h>
#include <unistd.h>

#include "engine/io/scene_loader.h"
#include "engine/render/render_session.h"
#include "engine/scene/generated_mesh.h"
#include "viewer/bench/bench.h"
#include "viewer/bench/bench_statistics.h"

namespace glint {
namespace {

struct LoadFigures {
    uint32_t triangles = 0;
    uint64_t bytes = 0;
    double load = 0.0;   ///< file to description
    double frame = 0.0;  ///< description to the first frame, of heavy scenes; 0: there is none
    double build = 0.0;  ///< description to acceleration structures and tables
    double image = 0.0;  ///< the rest, to the first picture
    double total = 0.0;
};

bool writeObj(const MeshData& mesh, const std::string& path) {
    std::FILE* file = std::fopen(path.c_str(), "w");
    if (file == nullptr) { return false; }
    for (const Vec3& p : mesh.positions) {
        fmt::print(file, "v {:.6f} {:.6f} {:.6f}\n", p.x, p.y, p.z);
    }
    for (const Vec3& n : mesh.normals) {
        fmt::print(file, "vn {:.4f} {:.4f} {:.4f}\n", n.x, n.y, n.z);
    }
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const uint32_t a = mesh.indices[i] + 1, b = mesh.indices[i + 1] + 1, c = mesh.indices[i + 2] + 1;
        fmt::print(file, "f {}//{} {}//{} {}//{}\n", a, a, b, b, c, c);
    }
    return std::fclose(file) == 0;
}

Result<LoadFigures> measureFile(const std::string& path, int threads) {
    LoadFigures figures;
    figures.bytes = std::filesystem::file_size(path);
    const Stopwatch stopwatch;
    auto scene = loadScene(path);
    if (!scene) { return scene.error(); }
    figures.load = stopwatch.seconds();
    for (const Mesh& mesh : scene->meshes) {
        figures.triangles += mesh.data->triangleCount();
    }
    SessionOptions options;
    options.threads = threads;
    RenderSession session(makeCpuBackend(threads), options);
    session.post({std::make_shared<SceneDescription>(std::move(*scene)), EditKind::Everything});
    const auto awaitImage = [&](const auto& isIt) {
        while (!(session.snapshot() && isIt(*session.snapshot())) &&
               session.status().state != SessionState::Failed) {
            usleep(500);
        }
    };
    awaitImage([](const FilmSnapshot&) { return true; });
    if (session.snapshot() && session.snapshot()->isFirstFrame) {
        figures.frame = stopwatch.seconds() - figures.load;
    }
    awaitImage([](const FilmSnapshot& image) { return !image.isFirstFrame; });
    figures.total = stopwatch.seconds();
    const SessionStatus status = session.status();
    if (status.state == SessionState::Failed) { return Error{status.error, {}}; }
    figures.build = status.lastBuildSeconds;
    figures.image = figures.total - figures.load - figures.frame - figures.build;
    return figures;
}

Result<LoadFigures> writeAndMeasure(const BenchOptions& options) {
    const MeshGenerator source{.name = "blob", .triangles = options.triangles};
    const auto mesh = generateMesh(source);
    if (!mesh) { return mesh.error(); }
    std::error_code problem;
    const auto folder =
        std::filesystem::temp_directory_path(problem) / fmt::format("glint-bench-{}", getpid());
    std::filesystem::create_directories(folder, problem);
    const std::string path = (folder / "mesh.obj").string();
    const bool written = writeObj(**mesh, path);
    auto figures = written ? measureFile(path, options.threads)
                           : Result<LoadFigures>(Error{fmt::format("cannot write '{}'", path), {}});
    std::filesystem::remove_all(folder, problem);
    return figures;
}

Result<BenchReport> measureLoad(const BenchSubject& subject) {
    const auto figures = writeAndMeasure(subject.options);
    if (!figures) { return figures.error(); }
    const std::string frame =
        figures->frame > 0.0 ? fmt::format("  first frame    {:7.3f} s\n", figures->frame) : "";
    return BenchReport{
        fmt::format("OBJ of {} triangles, {:.1f} MB\n", figures->triangles,
                    static_cast<double>(figures->bytes) * 1e-6) +
            fmt::format("  read           {:7.3f} s\n", figures->load) + frame +
            fmt::format("  build          {:7.3f} s\n", figures->build) +
            fmt::format("  first picture  {:7.3f} s\n  in all         {:7.3f} s\n", figures->image,
                        figures->total),
        {{"triangles", figures->triangles},
         {"file_bytes", figures->bytes},
         {"read_seconds", figures->load},
         {"first_frame_seconds", figures->frame > 0.0 ? nlohmann::ordered_json(figures->frame) : nullptr},
         {"build_seconds", figures->build},
         {"first_picture_seconds", figures->image},
         {"total_seconds", figures->total}}};
}

}  // namespace

Benchmark loadBenchmark() {
    return {.name = "load",
            .about = "An OBJ file to its first picture, by stages",
            .defaults = {.triangles = 500'000},
            .options = {trianglesOption(), threadsOption("Threads; all by default")},
            .scene = nullptr,
            .measure = measureLoad};
}

}  // namespace glint
