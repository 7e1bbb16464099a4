// `glint bench latency`: how long an edit takes to stop the pass in flight, and until a picture of the new
// state is there; and how long the window's own work of a frame takes meanwhile.
//
// A session renders as it does behind the window, and a script edits it: single edits of each kind with rests
// between them, which let full-resolution passes begin, and a drag of edits sixty times a second.
#include <chrono>
#include <thread>

#include <fmt/format.h>

#include "engine/render/render_session.h"
#include "viewer/bench/bench.h"
#include "viewer/bench/bench_scenes.h"
#include "viewer/bench/bench_statistics.h"
#include "viewer/bench/bench_window.h"

namespace glint {
namespace {

using Clock = std::chrono::steady_clock;
using Scene = std::shared_ptr<const SceneDescription>;

constexpr double kPatience = 60.0;
constexpr int kOutlinerObjects = 10000;

struct LatencyRow {
    std::string name;
    Percentiles cancel;
    Percentiles toImage;
};

void rest(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

/// The kinds a person uses, by turns, each with a change that is seen.
SceneEdit nextEdit(const Scene& scene, int step) {
    auto changed = std::make_shared<SceneDescription>(*scene);
    const float swing = std::sin(static_cast<float>(step));
    switch (step % 5) {
        case 0:
            changed->camera.position.x = 0.3f * swing;
            return {changed, EditKind::Camera};
        case 1:
            changed->camera.apertureDiameter = 0.05f * (1.0f + swing);
            return {changed, EditKind::Camera};
        case 2:
            changed->materials[0].color.value.x = 0.5f + 0.4f * swing;
            return {changed, EditKind::MaterialParameters};
        case 3:
            changed->environment.color = Vec3(0.1f + 0.1f * swing);
            return {changed, EditKind::Lights};
        default:
            changed->objects.back().objectToWorld.translation.x += 0.02f * swing;
            return {changed, EditKind::ObjectTransform};
    }
}

class Measurement {
  public:
    Measurement(const Scene& scene, int threads)
        : scene_(scene), session_(makeCpuBackend(threads), sessionOptions(threads)) {
        session_.post({scene_, EditKind::Everything});
        waitForImages(1);
        rest(0.3);
    }

    LatencyRow singleEdits(const std::string& name, int edits) {
        cancels_.clear();
        images_.clear();
        for (int step = 0; step < edits; ++step) {
            // Irregular, so that edits meet passes at every stage.
            rest(0.05 + 0.13 * ((step * 7919) % 101) / 101.0);
            edit(step);
        }
        return {name + ", single edits", percentilesOf(cancels_), percentilesOf(images_)};
    }

    LatencyRow drag(const std::string& name, int edits) {
        cancels_.clear();
        images_.clear();
        session_.request({.interacting = true});
        SessionStatus before = session_.status();
        for (int step = 0; step < edits; ++step) {
            session_.post(nextEdit(scene_, 0 + 5 * step));
            rest(1.0 / 60.0);
            const SessionStatus now = session_.status();
            if (now.imagesAfterEdits > before.imagesAfterEdits) {
                images_.push_back(now.lastEditToImageSeconds);
            }
            if (now.counters.passesDiscarded > before.counters.passesDiscarded) {
                cancels_.push_back(now.lastCancelSeconds);
            }
            before = now;
        }
        session_.request({});
        return {name + ", drag at 60 Hz", percentilesOf(cancels_), percentilesOf(images_)};
    }

  private:
    static SessionOptions sessionOptions(int threads) {
        SessionOptions options;
        options.threads = threads;
        return options;
    }

    void edit(int step) {
        const SessionStatus before = session_.status();
        session_.post(nextEdit(scene_, step));
        waitForImages(before.imagesAfterEdits + 1);
        const SessionStatus after = session_.status();
        images_.push_back(after.lastEditToImageSeconds);
        if (after.counters.passesDiscarded > before.counters.passesDiscarded) {
            cancels_.push_back(after.lastCancelSeconds);
        }
    }

    void waitForImages(uint64_t count) {
        const auto end = Clock::now() + std::chrono::duration<double>(kPatience);
        while (session_.status().imagesAfterEdits < count && Clock::now() < end) {
            rest(0.001);
        }
    }

    Scene scene_;
    RenderSession session_;
    std::vector<double> cancels_, images_;
};

Result<BenchReport> measureLatency(const BenchSubject& subject) {
    const BenchOptions& options = subject.options;
    const auto mesh = benchMesh(options.triangles, options.size, options.size);
    if (!mesh) { return mesh.error(); }
    std::vector<LatencyRow> rows;
    const auto measure = [&](const std::string& name, const Scene& scene) {
        Measurement measurement(scene, options.threads);
        rows.push_back(measurement.singleEdits(name, options.edits));
        rows.push_back(measurement.drag(name, options.edits));
    };
    measure("Cornell box", benchCornell(options.size, options.size));
    measure(fmt::format("mesh of {} triangles", (*mesh)->meshes[0].data->triangleCount()), *mesh);

    BenchReport report;
    report.json = {{"size", options.size}, {"rows", nlohmann::ordered_json::array()}};
    for (const LatencyRow& row : rows) {
        report.json["rows"].push_back({{"name", row.name},
                                       {"cancel", percentilesJson(row.cancel)},
                                       {"edit_to_picture", percentilesJson(row.toImage)}});
        report.text += fmt::format("{}\n  cancel           {}\n  edit to picture  {}\n", row.name,
                                   percentilesText(row.cancel), percentilesText(row.toImage));
    }
    const auto window = measureWindow(kOutlinerObjects, options.threads);
    report.json["window"] = {{"objects", kOutlinerObjects},
                             {"ui", window ? percentilesJson(*window) : nlohmann::ordered_json()}};
    report.text += fmt::format(
        "window, outliner of {} objects beside a render\n  input and panels {}\n", kOutlinerObjects,
        window ? percentilesText(*window) : "not measured: " + window.error().format());
    return report;
}

}  // namespace

Benchmark latencyBenchmark() {
    return {.name = "latency",
            .about = "Edit to stop and edit to picture, by a scripted session",
            .defaults = {.size = 512, .edits = 60, .triangles = 500'000},
            .options = {{"--edits", &BenchOptions::edits, "Edits of each kind of use", 1, 100000},
                        sizeOption("Picture width and height"),
                        trianglesOption(),
                        threadsOption("Render threads; all by default")},
            .scene = nullptr,
            .measure = measureLatency,
            .onError = kExitBadInput};
}

}  // namespace glint
