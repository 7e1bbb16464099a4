#include "viewer/model/preset_images.h"

#include <exception>
#include <memory>
#include <utility>

#include "engine/render/render_session.h"
#include "engine/render/snapshot.h"
#include "engine/scene/scene_building.h"

namespace glint {
namespace {

constexpr float kRadius = 0.44f;  // of balls whose squares have sides of 1
constexpr uint32_t kPasses = 24;
constexpr double kPollSeconds = 0.1;

int rowsOf(size_t count) {
    return static_cast<int>((count + PresetSheet::kColumns - 1) / PresetSheet::kColumns);
}

/// No pixels: it could not be rendered.
Thumbnail render(const BackendMaker& makeBackend, const MaterialPresetGroup& group) {
    auto backend = makeBackend();
    if (!backend) { return {}; }
    RenderSession session(std::move(*backend), {.previews = false, .snapshots = false});
    session.request({.limits = {.passes = kPasses}});
    const auto scene = std::make_shared<const SceneDescription>(presetScene(group));
    session.post({scene, EditKind::Everything});
    while (session.wait(kPollSeconds) != SessionState::Finished) {
        if (session.status().state == SessionState::Failed) { return {}; }
    }
    const auto capture = session.capture();
    if (!capture) { return {}; }
    const auto image = makeSnapshot(*capture, {}, 0);
    return makeThumbnail(*image, {.toneMap = ToneMap::Soft}, std::max(image->width, image->height));
}

}  // namespace

Vec2 PresetSheet::cornerOf(size_t preset) const {
    return Vec2(preset % kColumns, preset / kColumns) * cellSize();
}

Vec2 PresetSheet::cellSize() const {
    const auto share = [](int size) { return static_cast<float>(kSide) / static_cast<float>(size); };
    return thumbnail.rgba.empty() ? Vec2(0.0f) : Vec2(share(thumbnail.width), share(thumbnail.height));
}

SceneDescription presetScene(const MaterialPresetGroup& group) {
    const int rows = rowsOf(group.presets.size());
    constexpr int kColumns = PresetSheet::kColumns;
    SceneDescription scene;
    scene.resolution = {kColumns * PresetSheet::kSide, rows * PresetSheet::kSide};
    const Vec3 middle(0.5f * kColumns, -0.5f * static_cast<float>(rows), 0.0f);
    scene.camera.kind = ProjectionKind::Orthographic;
    scene.camera.viewHeight = static_cast<float>(rows);
    scene.camera.position = middle + Vec3(0.0f, 0.0f, 10.0f);
    scene.camera.target = middle;
    const SkySource sky{.sun = Vec3(120.0f), .sunAzimuthDeg = -60.0f, .sunRadiusDeg = 8.0f, .width = 256};
    scene.environmentImages = {{sky, nullptr, generateSky(sky)}};
    scene.environment = {.color = Vec3(1.0f), .strength = 1.0f, .image = 0};
    for (size_t i = 0; i < group.presets.size(); ++i) {
        scene.materials.push_back(group.presets[i].material);
        Object ball;
        ball.material = static_cast<int>(i);
        const Vec3 at(static_cast<float>(i % kColumns) + 0.5f, -static_cast<float>(i / kColumns) - 0.5f,
                      0.0f);
        ball.objectToWorld = translate(at) * scale(Vec3(kRadius));
        scene.objects.push_back(ball);
    }
    return scene;
}

PresetImages::PresetImages(JobQueue* jobs)
    : sheets(materialPresets().size()), jobs_(jobs), isAsked_(sheets.size(), false) {}

void PresetImages::ask(size_t group) {
    if (isAsked_[group] || !makeBackend) { return; }
    isAsked_[group] = true;
    jobs_->start(
        [this, group, maker = makeBackend]() -> JobQueue::Completion {
            auto rendered = std::make_shared<Thumbnail>();
            try {
                *rendered = render(maker, materialPresets()[group]);
            } catch (const std::exception&) {
                // The names alone will do.
            }
            return [this, group, rendered] { sheets[group].thumbnail = std::move(*rendered); };
        },
        false);
}

}  // namespace glint
