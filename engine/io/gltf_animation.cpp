// glTF 2.0 specification, section 3.11 and appendix C.
#include "engine/io/gltf_animation.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>

#include "engine/io/gltf_accessor.h"
#include "engine/io/gltf_parameters.h"

namespace glint {
namespace {

/// Between which two keys a time lies, and how far.
struct Span {
    size_t first = 0, second = 0;
    float share = 0.0f, seconds = 0.0f;
};

Span spanAt(const std::vector<float>& times, float seconds) {
    const auto next = static_cast<size_t>(std::ranges::upper_bound(times, seconds) - times.begin());
    if (next == 0) { return {}; }
    if (next == times.size()) { return {next - 1, next - 1}; }
    const float length = times[next] - times[next - 1];
    return {next - 1, next, length > 0.0f ? (seconds - times[next - 1]) / length : 0.0f, length};
}

glm::quat quaternionOf(const float* q) { return {q[3], q[0], q[1], q[2]}; }

/// `keys` has `width` numbers a key, or three times as many of splines: tangent, value, tangent.
std::vector<double> valueAt(const std::vector<float>& keys, size_t width, const std::string& interpolation,
                            bool isRotation, const Span& span) {
    const bool isSpline = interpolation == "CUBICSPLINE";
    const auto at = [&](size_t key, size_t part) { return &keys[(isSpline ? 3 * key + part : key) * width]; };
    const float* a = at(span.first, 1);
    const float* b = at(span.second, 1);
    const float t = interpolation == "STEP" ? 0.0f : span.share, s = 1.0f - t;
    if (isRotation && !isSpline) {
        const glm::quat q = glm::slerp(quaternionOf(a), quaternionOf(b), t);
        return {static_cast<double>(q.x), static_cast<double>(q.y), static_cast<double>(q.z),
                static_cast<double>(q.w)};
    }
    std::vector<double> value(width);
    for (size_t i = 0; i < width; ++i) {
        const float leaving = isSpline ? span.seconds * at(span.first, 2)[i] : 0.0f;
        const float arriving = isSpline ? span.seconds * at(span.second, 0)[i] : 0.0f;
        value[i] = static_cast<double>(isSpline ? s * s * (1.0f + 2.0f * t) * a[i] + t * s * s * leaving +
                                                      t * t * (3.0f - 2.0f * t) * b[i] - t * t * s * arriving
                                                : s * a[i] + t * b[i]);
    }
    return value;
}

class Pose {
  public:
    Pose(GltfFile* file, const tinygltf::Animation& animation) : file_(*file), animation_(animation) {}

    /// When it begins and ends.
    Status readTimes() {
        for (const tinygltf::AnimationChannel& channel : animation_.channels) {
            const auto times = timesOf(channel);
            if (!times) { return times.error(); }
            begin = std::min(begin, *std::ranges::min_element(*times));
            end = std::max(end, *std::ranges::max_element(*times));
        }
        return {};
    }

    Status apply(float seconds) {
        for (const tinygltf::AnimationChannel& channel : animation_.channels) {
            if (Status applied = apply(channel, seconds); !applied) { return applied; }
        }
        return {};
    }

    float begin = std::numeric_limits<float>::max(), end = 0.0f;

  private:
    Result<const tinygltf::AnimationSampler*> samplerOf(const tinygltf::AnimationChannel& channel) const {
        const auto index = static_cast<size_t>(std::max(channel.sampler, 0));
        if (channel.sampler < 0 || index >= animation_.samplers.size()) {
            return file_.error(
                fmt::format("animation {}: there is no sampler {}", animation_.name, channel.sampler));
        }
        return &animation_.samplers[index];
    }

    Result<std::vector<float>> timesOf(const tinygltf::AnimationChannel& channel) {
        const auto sampler = samplerOf(channel);
        if (!sampler) { return sampler.error(); }
        auto times = readNumbers(file_, (*sampler)->input, 1, 1, "animation, times");
        if (!times) { return times.error(); }
        constexpr uint64_t kMostNumbers = uint64_t{1} << 28;  // since channels may share their keys
        if ((numbersRead_ += times->count()) > kMostNumbers) {
            return file_.error(fmt::format("animation {}: its channels have too many keys", animation_.name));
        }
        if (times->values.empty() || !std::ranges::is_sorted(times->values) ||
            !std::isfinite(times->values.back())) {
            return file_.error(fmt::format("animation {}: its times do not grow", animation_.name));
        }
        return std::move(times->values);
    }

    Status apply(const tinygltf::AnimationChannel& channel, float seconds) {
        auto& nodes = file_.model.nodes;
        const auto index = static_cast<size_t>(std::max(channel.target_node, 0));
        const std::string& path = channel.target_path;
        const bool isWeights = path == "weights", isRotation = path == "rotation";
        if (channel.target_node < 0 || index >= nodes.size() ||
            !(isWeights || isRotation || path == "translation" || path == "scale")) {
            file_.remark("animations of anything but nodes and weights are left out", path);
            return {};
        }
        const auto times = timesOf(channel);
        if (!times) { return times.error(); }
        const tinygltf::AnimationSampler& sampler = **samplerOf(channel);
        const int components = isWeights ? 1 : isRotation ? 4 : 3;
        const auto keys = readNumbers(file_, sampler.output, components, components, "animation, " + path);
        if (!keys) { return keys.error(); }
        const size_t perKey = sampler.interpolation == "CUBICSPLINE" ? 3 : 1;
        const size_t width =
            isWeights ? keys->count() / (times->size() * perKey) : static_cast<size_t>(components);
        if (width == 0 || keys->values.size() != times->size() * perKey * width) {
            return file_.error(fmt::format("animation {}: {} values for {} times", animation_.name,
                                           keys->count(), times->size()));
        }
        tinygltf::Node& node = nodes[index];
        std::vector<double>& moved = isWeights               ? node.weights
                                     : isRotation            ? node.rotation
                                     : path == "translation" ? node.translation
                                                             : node.scale;
        moved = valueAt(keys->values, width, sampler.interpolation, isRotation, spanAt(*times, seconds));
        if (!isWeights) { node.matrix.clear(); }
        return {};
    }

    GltfFile& file_;
    const tinygltf::Animation& animation_;
    uint64_t numbersRead_ = 0;
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
    Pose pose(file, animation);
    if (Status times = pose.readTimes(); !times) { return times; }
    if (animation.channels.empty()) {
        file->remark("animations are left out: all stands as at rest", animation.name);
        return {};
    }
    double seconds = static_cast<double>(pose.begin);
    if (const std::string* time = findParameter(parameters, "time")) {
        const std::optional<double> number = numberIn(*time);
        if (!number) { return file->error(fmt::format("time={}: expected seconds", *time)); }
        seconds = *number;
    }
    *note = fmt::format(
        "animation {} \"{}\" of {}, from {:.4g} to {:.4g} s, stands at {:.4g} s (-D animation=, -D time=)",
        index, animation.name, file->model.animations.size(), pose.begin, pose.end, seconds);
    return pose.apply(static_cast<float>(seconds));
}

}  // namespace glint
