#include "viewer/base/camera_way.h"

#include <algorithm>
#include <limits>
#include <set>

#include <fmt/format.h>

#include "engine/render/first_hits.h"
#include "engine/scene/camera_path.h"
#include "engine/scene/object_box.h"

namespace glint {
namespace {

constexpr uint32_t kLeastSteps = 256;  // of the way: chords keep within 1e-4 of a turn's radius
constexpr uint32_t kMostSteps = 1024;  // so that the window can ask at any time

std::string nameOf(const SceneDescription& scene, uint32_t object) {
    const std::string& name = scene.objects[object - 1].name;
    return name.empty() ? fmt::format("object {}", object) : name;
}

/// "" where the camera goes through nothing.
std::string crossing(const CameraWay& way, const SceneDescription& scene, const BuiltScene& built) {
    const uint32_t images = way.images();
    const uint32_t gaps = way.isTurntable() ? images : images - 1;
    const uint32_t steps = std::clamp(gaps, kLeastSteps, kMostSteps);
    const auto alongAt = [&](uint32_t step) {
        return static_cast<float>(gaps) * static_cast<float>(step) / static_cast<float>(steps);
    };
    for (uint32_t step = 0; step < steps; ++step) {
        const Vec3 from = way.at(alongAt(step)).position, to = way.at(alongAt(step + 1)).position;
        const uint32_t object = firstHitBetween(built, from, to).object;
        if (object == 0 || object > scene.objects.size()) { continue; }
        return fmt::format("the camera goes through {} after picture {}", nameOf(scene, object),
                           static_cast<uint32_t>(alongAt(step)) + 1);
    }
    return "";
}

double sizeOf(const SceneDescription& scene, uint32_t object) {
    SceneDescription alone;
    alone.objects = {scene.objects[object - 1]};
    if (int& mesh = alone.objects[0].mesh; mesh >= 0) {
        alone.meshes = {scene.meshes[static_cast<size_t>(mesh)]};
        mesh = 0;
    }
    const Bounds bounds = sceneBounds(alone);
    // What has no end is as large as a wall.
    return bounds.empty() ? std::numeric_limits<double>::infinity()
                          : static_cast<double>(maxComponent(bounds.extent()));
}

/// Walls that a turn goes round. What is seen in the first picture may hide its own middle; so may its parts,
/// which are small beside the turn.
std::string hiding(const CameraWay& way, const SceneDescription& scene, const BuiltScene& built) {
    const Camera first = way.at(0.0f);
    const double radius = static_cast<double>(glm::length(first.position - first.target));
    const uint32_t lookedAt = firstHitBetween(built, first.position, first.target).object;
    std::set<uint32_t> small;
    const uint32_t stride = way.images() / kMostSteps + 1;
    for (uint32_t image = 1; image < way.images(); image += stride) {
        const Camera camera = way.at(static_cast<float>(image));
        const uint32_t object = firstHitBetween(built, camera.position, camera.target).object;
        if (object == 0 || object == lookedAt || object > scene.objects.size()) { continue; }
        if (small.contains(object)) { continue; }
        if (sizeOf(scene, object) < 0.5 * radius) {
            small.insert(object);
            continue;
        }
        return fmt::format("{} hides the target in picture {}", nameOf(scene, object), image + 1);
    }
    return "";
}

}  // namespace

Camera CameraWay::at(float image) const {
    if (isTurntable()) { return turnedCamera(views_[0], image / static_cast<float>(images_)); }
    const auto last = static_cast<float>(std::max(1u, images_ - 1));
    return cameraBetween(views_, image * static_cast<float>(views_.size() - 1) / last);
}

std::string obstaclesOn(const CameraWay& way, const SceneDescription& scene, const BuiltScene& built) {
    const std::string through = crossing(way, scene, built);
    const std::string hidden = way.isTurntable() ? hiding(way, scene, built) : "";
    return through + (through.empty() || hidden.empty() ? "" : ", and ") + hidden;
}

}  // namespace glint
