// Boxes of objects in double: the scenes that this is about are those where float would not do.
#include "engine/scene/stability_warnings.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/ext/matrix_double3x3.hpp>
#include <glm/ext/vector_double3.hpp>

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

struct Box {
    glm::dvec3 lo{INFINITY};
    glm::dvec3 hi{-INFINITY};

    void grow(const glm::dvec3& p) {
        lo = glm::min(lo, p);
        hi = glm::max(hi, p);
    }
    bool empty() const { return lo.x > hi.x; }
    double size() const { return std::max({hi.x - lo.x, hi.y - lo.y, hi.z - lo.z}); }
    double farthest() const {
        const glm::dvec3 a = glm::max(glm::abs(lo), glm::abs(hi));
        return std::max({a.x, a.y, a.z});
    }
};

Box meshBox(const MeshData& mesh) {
    Box box;
    for (const uint32_t index : mesh.indices) box.grow(glm::dvec3(mesh.positions[index]));
    return box;
}

std::vector<Box> meshBoxes(const SceneDescription& scene) {
    std::vector<Box> boxes;
    for (const Mesh& mesh : scene.meshes) boxes.push_back(mesh.data ? meshBox(*mesh.data) : Box{});
    return boxes;
}

/// In world space; empty for planes, which have no end, and for empty meshes.
Box objectBox(const Object& object, const std::vector<Box>& meshes) {
    Box local{glm::dvec3(-1.0), glm::dvec3(1.0)};
    if (object.shape == ShapeKind::Plane) return {};
    if (object.shape == ShapeKind::Mesh) {
        const auto index = static_cast<size_t>(object.mesh);
        local = object.mesh >= 0 && index < meshes.size() ? meshes[index] : Box{};
    } else if (object.shape != ShapeKind::Sphere) {
        local.lo.z = local.hi.z = 0.0;
    }
    if (local.empty()) return {};
    Box box;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p((corner & 1) != 0 ? local.hi.x : local.lo.x,
                           (corner & 2) != 0 ? local.hi.y : local.lo.y,
                           (corner & 4) != 0 ? local.hi.z : local.lo.z);
        box.grow(glm::dmat3(object.objectToWorld.linear) * p + glm::dvec3(object.objectToWorld.translation));
    }
    return box;
}

std::string nameOf(const SceneDescription& scene, size_t index) {
    const std::string& name = scene.objects[index].name;
    return name.empty() ? fmt::format("object {}", index + 1) : fmt::format("object '{}'", name);
}

class Search {
  public:
    explicit Search(const SceneDescription& scene) : scene_(scene) {
        const std::vector<Box> meshes = meshBoxes(scene);
        for (const Object& object : scene.objects) boxes_.push_back(objectBox(object, meshes));
        for (size_t i = 0; i < boxes_.size(); ++i) {
            if (boxes_[i].empty() || !(boxes_[i].size() > 0.0)) continue;
            if (smallest_ < 0 || boxes_[i].size() < box(smallest_).size()) smallest_ = static_cast<int>(i);
            if (largest_ < 0 || boxes_[i].size() > box(largest_).size()) largest_ = static_cast<int>(i);
        }
    }

    std::vector<std::string> run() {
        if (smallest_ >= 0) {
            checkLengths();
            checkSpan();
            checkDistances();
        }
        checkBrightness();
        return std::move(warnings_);
    }

  private:
    const Box& box(int index) const { return boxes_[static_cast<size_t>(index)]; }
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
            if (boxes_[i].empty() || !(boxes_[i].size() < kLeastSizePerDistance * boxes_[i].farthest()))
                continue;
            if (count++ == 0) first = i;
        }
        if (count == 0) return;
        const double steps = boxes_[first].size() / (boxes_[first].farthest() * 0x1p-24);
        warnings_.push_back(
            fmt::format("{} lies {:.2g} times its size from the origin, so that it is only {:.2g} steps of "
                        "float across{}; "
                        "move the scene towards the origin",
                        nameOf(scene_, first), boxes_[first].farthest() / boxes_[first].size(), steps,
                        count > 1 ? fmt::format(" (and {} more objects)", count - 1) : ""));
    }

    void checkBrightness() {
        for (const Material& material : scene_.materials) {
            const double radiance = static_cast<double>(maxComponent(material.emission)) *
                                    static_cast<double>(material.emissionStrength);
            if (radiance <= kBrightestRadiance) continue;
            warnings_.push_back(
                fmt::format("material '{}' emits a radiance of {:.2g}; sums of more than 3e38 overflow",
                            material.name, radiance));
        }
    }

    const SceneDescription& scene_;
    std::vector<Box> boxes_;
    int smallest_ = -1;
    int largest_ = -1;
    std::vector<std::string> warnings_;
};

}  // namespace

std::vector<std::string> stabilityWarnings(const SceneDescription& scene) { return Search(scene).run(); }

}  // namespace glint
