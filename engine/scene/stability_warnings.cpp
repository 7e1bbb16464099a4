// Boxes of objects in double: the scenes that this is about are those where float would not do.
#include "engine/scene/stability_warnings.h"

#include <algorithm>
#include <cmath>

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

std::string nameOf(const SceneDescription& scene, size_t index) {
    const std::string& name = scene.objects[index].name;
    return name.empty() ? fmt::format("object {}", index + 1) : fmt::format("object '{}'", name);
}

class Search {
  public:
    explicit Search(const SceneDescription& scene) : scene_(scene) {
        std::vector<WideBox> meshes;
        for (const Mesh& mesh : scene.meshes) meshes.push_back(mesh.data ? meshBox(*mesh.data) : WideBox{});
        for (const Object& object : scene.objects) {
            const auto index = static_cast<size_t>(object.mesh);
            const bool isMesh = object.shape == ShapeKind::Mesh && index < meshes.size();
            boxes_.push_back(
                placedBox(object.shape, object.objectToWorld, isMesh ? meshes[index] : WideBox{}));
        }
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
            if (boxes_[i].empty() || !(boxes_[i].size() < kLeastSizePerDistance * boxes_[i].farthest()))
                continue;
            if (count++ == 0) first = i;
        }
        if (count == 0) return;
        const double step = std::exp2(std::floor(std::log2(boxes_[first].farthest())) - 23.0);
        warnings_.push_back(fmt::format(
            "{} lies {:.2g} times its size from the origin, where float holds coordinates in "
            "steps of {:.2g} units, {:.2g} of them across it{}; subtract an offset in the "
            "program that writes the file",
            nameOf(scene_, first), boxes_[first].farthest() / boxes_[first].size(), step,
            boxes_[first].size() / step, count > 1 ? fmt::format(" (and {} more objects)", count - 1) : ""));
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
    std::vector<WideBox> boxes_;
    int smallest_ = -1;
    int largest_ = -1;
    std::vector<std::string> warnings_;
};

}  // namespace

std::vector<std::string> stabilityWarnings(const SceneDescription& scene) { return Search(scene).run(); }

}  // namespace glint
