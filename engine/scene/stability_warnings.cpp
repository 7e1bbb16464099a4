// Boxes of objects in double: the scenes that this is about are those where float would not do.
#include "engine/scene/stability_warnings.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <fmt/format.h>

#include "engine/scene/object_box.h"

namespace glint {
namespace {

/// An object smaller than this part of its distance from the origin has corners of a few steps of float.
constexpr double kLeastSizePerDistance = 1e-4;
/// Products of three lengths must neither overflow nor vanish.
constexpr double kLongestLength = 1e12;
constexpr double kShortestLength = 1e-12;
/// The smallest object beside the largest one.
constexpr double kLargestSpan = 1e7;
constexpr double kBrightestRadiance = 1e30;
/// Surfaces closer than this part of their coordinates are in one place.
constexpr double kLeastGap = 1e-7;

std::string nameOf(const SceneDescription& scene, size_t index) {
    const std::string& name = scene.objects[index].name;
    return name.empty() ? fmt::format("object {}", index + 1) : fmt::format("object '{}'", name);
}

class Search {
  public:
    explicit Search(const SceneDescription& scene) : scene_(scene) {
        std::vector<WideBox> meshes;
        for (const Mesh& mesh : scene.meshes) {
            meshes.push_back(mesh.data ? meshBox(*mesh.data) : WideBox{});
        }
        for (const Object& object : scene.objects) {
            const auto index = static_cast<size_t>(object.mesh);
            const bool isMesh = object.shape == ShapeKind::Mesh && index < meshes.size();
            boxes_.push_back(placedBox(object, isMesh ? meshes[index] : WideBox{}));
        }
        for (size_t i = 0; i < boxes_.size(); ++i) {
            if (boxes_[i].empty() || !(boxes_[i].size() > 0.0)) { continue; }
            if (smallest_ < 0 || boxes_[i].size() < box(smallest_).size()) {
                smallest_ = static_cast<int>(i);
            }
            if (largest_ < 0 || boxes_[i].size() > box(largest_).size()) { largest_ = static_cast<int>(i); }
        }
    }

    std::vector<std::string> run() {
        if (smallest_ >= 0) {
            checkLengths();
            checkSpan();
            checkDistances();
        }
        checkAreas();
        checkSamePlace();
        checkTouchingGlass();
        checkBrightness();
        return std::move(warnings_);
    }

  private:
    const WideBox& box(int index) const { return boxes_[static_cast<size_t>(index)]; }
    std::string name(int index) const { return nameOf(scene_, static_cast<size_t>(index)); }

    void checkLengths() {
        if (box(largest_).size() > kLongestLength) {
            warnings_.push_back(fmt::format(
                "{} is {:.2g} units long; products of such lengths leave float's range, use a larger unit",
                name(largest_), box(largest_).size()));
        }
        if (box(smallest_).size() < kShortestLength) {
            warnings_.push_back(fmt::format(
                "{} is {:.2g} units long; products of such lengths leave float's range, use a smaller unit",
                name(smallest_), box(smallest_).size()));
        }
    }

    void checkSpan() {
        const double span = box(largest_).size() / box(smallest_).size();
        if (span > kLargestSpan) {
            warnings_.push_back(fmt::format(
                "the scene spans {:.2g} of its smallest units: {} is {:.2g} long and {} {:.2g}; far from the "
                "origin the small one is beyond float's resolution",
                span, name(smallest_), box(smallest_).size(), name(largest_), box(largest_).size()));
        }
    }

    void checkDistances() {
        size_t count = 0;
        size_t first = 0;
        for (size_t i = 0; i < boxes_.size(); ++i) {
            if (boxes_[i].empty() || !(boxes_[i].size() > 0.0) ||
                !(boxes_[i].size() < kLeastSizePerDistance * boxes_[i].farthest())) {
                continue;
            }
            if (count++ == 0) { first = i; }
        }
        if (count == 0) { return; }
        const double step = std::exp2(std::floor(std::log2(boxes_[first].farthest())) - 23.0);
        warnings_.push_back(fmt::format(
            "{} lies {:.2g} times its size from the origin, where float holds coordinates in "
            "steps of {:.2g} units, {:.2g} of them across it{}; subtract an offset in the "
            "program that writes the file",
            nameOf(scene_, first), boxes_[first].farthest() / boxes_[first].size(), step,
            boxes_[first].size() / step, count > 1 ? fmt::format(" (and {} more objects)", count - 1) : ""));
    }

    static bool hasArea(const MeshData& mesh) {
        for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            const glm::dvec3 a(mesh.positions[mesh.indices[i]]);
            const glm::dvec3 b(mesh.positions[mesh.indices[i + 1]]);
            const glm::dvec3 c(mesh.positions[mesh.indices[i + 2]]);
            if (glm::cross(b - a, c - a) != glm::dvec3(0.0)) { return true; }
        }
        return false;
    }

    /// Whether a profile is a point, or lies on the axis.
    static bool turnsNothing(const std::vector<Vec2>& profile) {
        const auto isFirst = [&](const Vec2& p) { return p == profile.front(); };
        const auto isOnAxis = [](const Vec2& p) { return p.x == 0.0f; };
        return std::ranges::all_of(profile, isFirst) || std::ranges::all_of(profile, isOnAxis);
    }

    bool lacksArea(size_t index) const {
        const Object& object = scene_.objects[index];
        if (object.shape == ShapeKind::Revolved) { return turnsNothing(object.profile); }
        return triangleCount(index) > 0 && !hasArea(*scene_.meshes[static_cast<size_t>(object.mesh)].data);
    }

    void checkAreas() {
        size_t count = 0;
        size_t first = 0;
        for (size_t i = 0; i < scene_.objects.size(); ++i) {
            if (lacksArea(i) && count++ == 0) { first = i; }
        }
        if (count == 0) { return; }
        warnings_.push_back(fmt::format(
            "{} has no area{}: it is made of points or lines, which are not seen and do not shine",
            nameOf(scene_, first), count > 1 ? fmt::format(" (and {} more objects)", count - 1) : ""));
    }

    /// Closer than float's last few places of their coordinates.
    static bool samePlace(const WideBox& a, const WideBox& b) {
        const double near = kLeastGap * std::max(a.farthest(), b.farthest());
        const auto within = [&](const glm::dvec3& d) {
            return std::abs(d.x) <= near && std::abs(d.y) <= near && std::abs(d.z) <= near;
        };
        return within(a.lo - b.lo) && within(a.hi - b.hi);
    }

    uint32_t triangleCount(size_t object) const {
        const Object& o = scene_.objects[object];
        const auto mesh = static_cast<size_t>(o.mesh);
        const bool known =
            o.shape == ShapeKind::Mesh && mesh < scene_.meshes.size() && scene_.meshes[mesh].data;
        return known ? scene_.meshes[mesh].data->triangleCount() : 0;
    }

    /// Each is seen from a side of its own.
    static bool areFrontAndBack(const Object& a, const Object& b) {
        const bool isTurned =
            a.mesh != b.mesh || glm::dot(a.objectToWorld.linear[2], b.objectToWorld.linear[2]) < 0.0f;
        return a.frontOnly && b.frontOnly && isTurned;
    }

    /// Objects that an exporter wrote twice: with one material nobody sees it.
    void checkSamePlace() {
        std::vector<size_t> order;
        for (size_t i = 0; i < boxes_.size(); ++i) {
            if (!boxes_[i].empty() && boxes_[i].size() > 0.0) { order.push_back(i); }
        }
        const auto key = [&](size_t i) { return std::tuple(boxes_[i].lo.x, boxes_[i].lo.y, boxes_[i].lo.z); };
        std::ranges::sort(order, {}, key);
        for (size_t k = 1; k < order.size(); ++k) {
            const size_t a = std::min(order[k - 1], order[k]);
            const size_t b = std::max(order[k - 1], order[k]);
            const Object &first = scene_.objects[a], &second = scene_.objects[b];
            const bool alike = first.shape == second.shape && triangleCount(a) == triangleCount(b);
            if (!alike || first.material == second.material || !samePlace(boxes_[a], boxes_[b]) ||
                areFrontAndBack(first, second)) {
                continue;
            }
            warnings_.push_back(fmt::format(
                "{} and {} lie in one place with different materials; which of the two is seen is open",
                nameOf(scene_, a), nameOf(scene_, b)));
            return;
        }
    }

    bool isGlass(size_t object) const {
        const auto index = static_cast<size_t>(scene_.objects[object].material);
        return index < scene_.materials.size() && (scene_.materials[index].kind == MaterialKind::Dielectric ||
                                                   transmits(scene_.materials[index]));
    }

    /// Whether the boxes meet in a part of a side, with nothing between them and nothing overlapping.
    static bool touch(const WideBox& a, const WideBox& b) {
        const double near = kLeastGap * std::max(a.farthest(), b.farthest());
        int touching = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const double overlap = std::min(a.hi[axis], b.hi[axis]) - std::max(a.lo[axis], b.lo[axis]);
            if (overlap < -near) { return false; }
            touching += overlap <= near ? 1 : 0;
        }
        return touching == 1;
    }

    void checkTouchingGlass() {
        constexpr size_t kMostBodies = 256;
        std::vector<size_t> bodies;
        for (size_t i = 0; i < boxes_.size() && bodies.size() < kMostBodies; ++i) {
            if (!boxes_[i].empty() && scene_.objects[i].shape == ShapeKind::Mesh && isGlass(i)) {
                bodies.push_back(i);
            }
        }
        for (size_t i = 0; i < bodies.size(); ++i) {
            for (size_t k = i + 1; k < bodies.size(); ++k) {
                if (!touch(boxes_[bodies[i]], boxes_[bodies[k]])) { continue; }
                warnings_.push_back(fmt::format(
                    "{} and {} are glass and touch; where they share a face light goes astray: model the one "
                    "surface between them, or leave a gap",
                    nameOf(scene_, bodies[i]), nameOf(scene_, bodies[k])));
                return;
            }
        }
    }

    void checkBrightness() {
        for (const Material& material : scene_.materials) {
            const double radiance = static_cast<double>(maxComponent(material.emission.value)) *
                                    static_cast<double>(material.emissionStrength);
            if (radiance <= kBrightestRadiance) { continue; }
            warnings_.push_back(
                fmt::format("material '{}' emits a radiance of {:.2g}; sums of more than 3e38 overflow",
                            material.name, radiance));
        }
    }

    const SceneDescription& scene_;
    std::vector<WideBox> boxes_;
    int smallest_ = -1;
    int largest_ = -1;
    std::vector<std::string> warnings_;
};

}  // namespace

std::vector<std::string> stabilityWarnings(const SceneDescription& scene) { return Search(scene).run(); }

}  // namespace glint
