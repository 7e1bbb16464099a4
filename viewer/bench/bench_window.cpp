#include "viewer/bench/bench_window.h"

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "engine/scene/scene.h"
#include "viewer/base/make_backend.h"
#if GLINT_HAS_VIEWER
#include "viewer/window/app.h"
#endif

namespace glint {

#if GLINT_HAS_VIEWER

namespace {

constexpr const char* kScript = R"(
wait passes 1
open "Outliner"
wait frames 30
click "Go to Outliner"
wait frames 30
move "Object 1: ball 1"
wheel -30
wait frames 30
wheel -300
wait frames 30
set "Search" "77"
wait frames 30
set "Search" ""
wait frames 4
click "Go to Object"
wait frames 4
drag "Image" 60 0
wait frames 60
)";

SceneDescription ballsInRows(int count) {
    SceneDescription scene;
    scene.resolution = {512, 384};
    scene.environment.color = Vec3(1.0f);
    scene.materials.resize(1);
    const int columns = static_cast<int>(std::ceil(std::sqrt(count)));
    for (int i = 0; i < count; ++i) {
        Object ball;
        ball.name = fmt::format("ball {}", i + 1);
        ball.material = 0;
        const Vec3 at(static_cast<float>(i % columns), 0.0f, static_cast<float>(-(i / columns)));
        ball.objectToWorld = translate(at) * scale(Vec3(0.4f));
        scene.objects.push_back(std::move(ball));
    }
    const auto side = static_cast<float>(columns);
    scene.camera.position = {0.5f * side, 0.6f * side, 0.7f * side};
    scene.camera.target = {0.5f * side, 0.0f, -0.5f * side};
    scene.camera.focalDistance = glm::length(scene.camera.target - scene.camera.position);
    return scene;
}

}  // namespace

Result<Percentiles> measureWindow(int objects, int threads) {
    auto script = parseScript(kScript, "bench latency");
    if (!script) { return script.error(); }
    auto backend = makeBackend("cpu", threads);
    if (!backend) { return backend.error(); }
    std::vector<double> seconds;
    ViewerOptions options;
    options.headless = true;
    options.surface = {.width = 1280, .height = 720, .contentScale = 1.0f};
    options.script = std::move(*script);
    options.uiSeconds = &seconds;
    bool scriptFailed = false;
    const Result<bool> ran = runViewer(options, std::move(*backend), ballsInRows(objects), &scriptFailed);
    if (!ran) { return ran.error(); }
    return percentilesOf(std::move(seconds));
}

#else

Result<Percentiles> measureWindow(int, int) { return Error{"this build has no window", {}}; }

#endif

}  // namespace glint
