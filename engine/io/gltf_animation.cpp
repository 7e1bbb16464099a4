// glTF 2.0 specification, section 3.11 and appendix C.
#include "engine/io/gltf_animation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <tuple>

#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>

#include "engine/io/gltf_accessor.h"
#include "engine/io/gltf_parameters.h"

namespace glint {
namespace {

/// Channels may share accessors, and those without a buffer cost a file nothing: what is read is bound by the
/// bytes of its buffers, and by so many numbers whatever these are.
constexpr uint64_t kFreeNumbers = uint64_t{1} << 20;

/// Between which two keys a time lies, and how far: the same key twice at the ends.
struct Span {
    size_t first = 0, second = 0;
    double share = 0.0;    ///< in [0, 1)
    double seconds = 0.0;  ///< between both
};

Span spanAt(std::span<const float> times, float seconds) {
    const auto next = static_cast<size_t>(std::ranges::upper_bound(times, seconds) - times.begin());
    if (next == 0) { return {}; }
    if (next == times.size()) { return {.first = next - 1, .second = next - 1}; }
    const double begin = times[next - 1], length = double{times[next]} - begin;
    return {next - 1, next, (double{seconds} - begin) / length, length};
}

using Numbers = std::vector<double>;

/// The shortest way (appendix C.3).
Numbers slerpOf(const Numbers& before, const Numbers& after, double share) {
    const auto unit = [](const Numbers& q) { return glm::normalize(glm::dquat(q[3], q[0], q[1], q[2])); };
    const glm::dquat q = glm::slerp(unit(before), unit(after), share);
    return {q.x, q.y, q.z, q.w};
}

Numbers mixOf(Numbers before, const Numbers& after, double share) {
    for (size_t i = 0; i < before.size(); ++i) {
        before[i] += share * (after[i] - before[i]);
    }
    return before;
}

/// Hermite's spline (appendix C.4) from the value and tangent at the key before, then at the key after.
Numbers cubicOf(const std::array<Numbers, 4>& given, const Span& span) {
    const double t = span.share, t2 = t * t, t3 = t2 * t;
    const double basis[] = {2.0 * t3 - 3.0 * t2 + 1.0, span.seconds * (t3 - 2.0 * t2 + t),
                            3.0 * t2 - 2.0 * t3, span.seconds * (t3 - t2)};
    Numbers values(given[0].size());
    for (size_t i = 0; i < values.size(); ++i) {
        for (size_t k = 0; k < 4; ++k) {
            values[i] += basis[k] * given[k][i];
        }
    }
    return values;
}

class Pose {
  public:
    Pose(GltfFile* file, const tinygltf::Animation& animation) : file_(*file), animation_(animation) {
        for (const tinygltf::Buffer& buffer : file_.model.buffers) {
            numbersLeft_ += buffer.data.size();
        }
    }

    /// When it begins and ends; 0 where it has no keys that can be read.
    std::pair<float, float> readTimes() {
        float begin = std::numeric_limits<float>::max(), end = std::numeric_limits<float>::lowest();
        for (const tinygltf::AnimationChannel& channel : animation_.channels) {
            const auto sampler = samplerOf(channel);
            if (!sampler || !timesOf((*sampler)->input)) { continue; }
            begin = std::min(begin, timesOf((*sampler)->input)->front());
            end = std::max(end, timesOf((*sampler)->input)->back());
        }
        return begin <= end ? std::pair(begin, end) : std::pair(0.0f, 0.0f);
    }

    void apply(float seconds) {
        for (const tinygltf::AnimationChannel& channel : animation_.channels) {
            const std::string& path = channel.target_path;
            if (channel.target_node < 0 ||
                !(path == "weights" || path == "rotation" || path == "translation" || path == "scale")) {
                file_.remark("animations of anything but nodes and weights are left out", path);
            } else if (const Status applied = apply(channel, seconds); !applied) {
                file_.remark("channels of the animation that cannot be read are left out",
                             applied.error().message);
            }
        }
    }

  private:
    Result<const tinygltf::AnimationSampler*> samplerOf(const tinygltf::AnimationChannel& channel) const {
        const auto index = static_cast<size_t>(std::max(channel.sampler, 0));
        if (channel.sampler < 0 || index >= animation_.samplers.size()) {
            return file_.error(fmt::format("there is no sampler {}", channel.sampler));
        }
        return &animation_.samplers[index];
    }

    Status apply(const tinygltf::AnimationChannel& channel, float seconds) {
        auto& nodes = file_.model.nodes;
        const auto index = static_cast<size_t>(channel.target_node);
        if (index >= nodes.size()) { return file_.error(fmt::format("there is no node {}", index)); }
        const auto sampler = samplerOf(channel);
        if (!sampler) { return sampler.error(); }
        tinygltf::Node& node = nodes[index];
        const std::string& path = channel.target_path;
        const auto [width, moved] = path == "weights"    ? std::pair(targetsOf(node), &node.weights)
                                    : path == "rotation" ? std::pair(size_t{4}, &node.rotation)
                                    : path == "scale"    ? std::pair(size_t{3}, &node.scale)
                                                         : std::pair(size_t{3}, &node.translation);
        auto values = valuesAt(**sampler, width, path == "rotation", seconds);
        if (!values) { return values.error(); }
        *moved = std::move(*values);
        if (path != "weights") { node.matrix.clear(); }
        return {};
    }

    size_t targetsOf(const tinygltf::Node& node) const {
        const auto& meshes = file_.model.meshes;
        if (node.mesh < 0 || static_cast<size_t>(node.mesh) >= meshes.size()) { return 0; }
        const auto& primitives = meshes[static_cast<size_t>(node.mesh)].primitives;
        return primitives.empty() ? 0 : primitives.front().targets.size();
    }

    /// The sampler's `width` numbers.
    Result<Numbers> valuesAt(const tinygltf::AnimationSampler& sampler, size_t width, bool isRotation,
                             float seconds) {
        const bool isCubic = sampler.interpolation == "CUBICSPLINE", isStep = sampler.interpolation == "STEP";
        if (!isCubic && !isStep && sampler.interpolation != "LINEAR") {
            return file_.error(fmt::format("interpolation \"{}\" is unknown", sampler.interpolation));
        }
        const auto& times = timesOf(sampler.input);
        if (!times) { return times.error(); }
        const Result<GltfNumbers>& numbers = numbersOf(sampler.output);
        if (!numbers) { return numbers.error(); }
        const size_t parts = isCubic ? 3 : 1, expected = times->size() * parts * width;
        if (!takeNumbers(width)) { return file_.error("its channels have too many numbers"); }
        if (numbers->values.size() != expected) {
            return file_.error(fmt::format("accessor {} has {} numbers; expected {} for {} keys",
                                           sampler.output, numbers->values.size(), expected, times->size()));
        }
        const auto at = [&](size_t key, size_t part) {
            const float* first = numbers->values.data() + (key * parts + part) * width;
            return Numbers(first, first + width);
        };
        const Span span = spanAt(*times, seconds);
        const size_t middle = isCubic ? 1 : 0;
        Numbers values = at(span.first, middle);
        if (span.share > 0.0 && !isStep) {
            const Numbers after = at(span.second, middle);
            if (isCubic) {
                values = cubicOf({values, at(span.first, 2), after, at(span.second, 0)}, span);
            } else {
                values = isRotation ? slerpOf(values, after, span.share) : mixOf(values, after, span.share);
            }
        }
        if (std::ranges::all_of(values, [](double value) { return std::isfinite(value); })) { return values; }
        return file_.error(fmt::format("accessor {} is not finite", sampler.output));
    }

    const Result<std::span<const float>>& timesOf(int accessor) {
        const auto known = times_.find(accessor);
        if (known != times_.end()) { return known->second; }
        return times_.emplace(accessor, readTimes(accessor)).first->second;
    }

    Result<std::span<const float>> readTimes(int accessor) {
        const Result<GltfNumbers>& numbers = numbersOf(accessor);
        if (!numbers) { return numbers.error(); }
        const std::vector<float>& times = numbers->values;
        const bool areFinite = std::ranges::all_of(times, [](float time) { return std::isfinite(time); });
        if (!areFinite || times.empty() || !std::ranges::is_sorted(times)) {
            return file_.error(fmt::format("the times of accessor {} do not grow", accessor));
        }
        return std::span<const float>(times);
    }

    const Result<GltfNumbers>& numbersOf(int accessor) {
        const auto known = numbers_.find(accessor);
        if (known != numbers_.end()) { return known->second; }
        const auto& accessors = file_.model.accessors;
        uint64_t count = 0;
        if (accessor >= 0 && static_cast<size_t>(accessor) < accessors.size()) {
            const tinygltf::Accessor& from = accessors[static_cast<size_t>(accessor)];
            const int width = tinygltf::GetNumComponentsInType(static_cast<uint32_t>(from.type));
            count = from.count * static_cast<uint64_t>(std::max(width, 1));
        }
        const Result<GltfNumbers> read =
            takeNumbers(count)
                ? readNumbers(file_, accessor, 1, 4, "animation")
                : Result<GltfNumbers>(file_.error("its animations hold more numbers than its bytes can"));
        return numbers_.emplace(accessor, read).first->second;
    }

    bool takeNumbers(uint64_t count) {
        const bool isEnough = count <= numbersLeft_;
        numbersLeft_ -= isEnough ? count : 0;
        return isEnough;
    }

    GltfFile& file_;
    const tinygltf::Animation& animation_;
    uint64_t numbersLeft_ = kFreeNumbers;
    std::map<int, Result<GltfNumbers>> numbers_;           ///< by accessor
    std::map<int, Result<std::span<const float>>> times_;  ///< within `numbers_`
};

}  // namespace

Status poseNodes(GltfFile* file, const SceneParameters& parameters, std::string* note) {
    std::vector<std::string> names;
    std::ranges::transform(file->model.animations, std::back_inserter(names), &tinygltf::Animation::name);
    const auto chosen = chosenBy(parameters, "animation", names, *file);
    if (!chosen) { return chosen.error(); }
    if (names.empty()) { return {}; }
    const size_t index = chosen->value_or(0);
    const tinygltf::Animation& animation = file->model.animations[index];
    if (animation.channels.empty()) {
        file->remark("animations are left out: all stands as at rest", animation.name);
        return {};
    }
    Pose pose(file, animation);
    const auto [begin, end] = pose.readTimes();
    double seconds = double{begin};
    if (const std::string* time = findParameter(parameters, "time")) {
        const std::optional<double> number = numberIn(*time);
        if (!number) { return file->error(fmt::format("time={}: expected seconds", *time)); }
        seconds = *number;
    }
    *note = fmt::format(
        "animation {} \"{}\" of {}, from {:.4g} to {:.4g} s, stands at {:.4g} s (-D animation=, -D time=)",
        index, animation.name, file->model.animations.size(), begin, end, seconds);
    pose.apply(static_cast<float>(seconds));
    return {};
}

}  // namespace glint
