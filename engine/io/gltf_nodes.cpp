#include "engine/io/gltf_nodes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <tuple>

#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>

#include "engine/io/gltf_accessor.h"

namespace glint {
namespace {

constexpr size_t kMaxInstances = 1'000'000;

}  // namespace

Affine placementOf(const tinygltf::Node& node) {
    const auto at = [](const std::vector<double>& values, size_t i) { return static_cast<float>(values[i]); };
    if (const auto& m = node.matrix; m.size() == 16) {
        return {
            Mat3(at(m, 0), at(m, 1), at(m, 2), at(m, 4), at(m, 5), at(m, 6), at(m, 8), at(m, 9), at(m, 10)),
            Vec3(at(m, 12), at(m, 13), at(m, 14))};
    }
    Affine placement;
    if (const auto& q = node.rotation; q.size() == 4) {
        const glm::dquat rotation(q[3], q[0], q[1], q[2]);
        const double length = glm::length(rotation);
        if (length > 0.0) { placement.linear = Mat3(glm::mat3_cast(rotation / length)); }
    }
    if (const auto& s = node.scale; s.size() == 3) {
        placement.linear = placement.linear * Mat3(at(s, 0), 0, 0, 0, at(s, 1), 0, 0, 0, at(s, 2));
    }
    if (const auto& t = node.translation; t.size() == 3) {
        placement.translation = Vec3(at(t, 0), at(t, 1), at(t, 2));
    }
    return placement;
}

Result<std::vector<Affine>> instancesOf(const GltfFile& file, const tinygltf::Node& node) {
    const auto* extension = extensionOf(node, "EXT_mesh_gpu_instancing");
    if (extension == nullptr || !extension->Get("attributes").IsObject()) { return std::vector<Affine>(1); }
    const tinygltf::Value& attributes = extension->Get("attributes");
    std::vector<tinygltf::Node> nodes;
    const std::tuple<const char*, int, std::vector<double> tinygltf::Node::*> parts[] = {
        {"TRANSLATION", 3, &tinygltf::Node::translation},
        {"ROTATION", 4, &tinygltf::Node::rotation},
        {"SCALE", 3, &tinygltf::Node::scale}};
    for (const auto& [name, width, member] : parts) {
        if (!attributes.Has(name)) { continue; }
        const auto accessor = indexOf(&attributes, name);
        const auto values = readNumbers(file, accessor, width, width, fmt::format("instances, {}", name));
        if (!values) { return values.error(); }
        if (values->count() > kMaxInstances) {
            return file.error(
                fmt::format("a node has {} instances; at most {} are read", values->count(), kMaxInstances));
        }
        nodes.resize(std::max(nodes.size(), values->count()));
        for (size_t i = 0; i < values->count(); ++i) {
            (nodes[i].*member).assign(values->at(i), values->at(i) + width);
        }
    }
    std::vector<Affine> places;
    std::ranges::transform(nodes, std::back_inserter(places),
                           [](const tinygltf::Node& place) { return placementOf(place); });
    return places;
}

std::vector<int> rootsOf(const tinygltf::Model& model) {
    const auto& scenes = model.scenes;
    const size_t index = static_cast<size_t>(std::max(model.defaultScene, 0));
    if (index < scenes.size()) { return scenes[index].nodes; }
    std::vector<bool> isChild(model.nodes.size(), false);
    for (const tinygltf::Node& node : model.nodes) {
        for (const int child : node.children) {
            if (child >= 0 && static_cast<size_t>(child) < isChild.size()) {
                isChild[static_cast<size_t>(child)] = true;
            }
        }
    }
    std::vector<int> roots;
    for (size_t i = 0; i < isChild.size(); ++i) {
        if (!isChild[i]) { roots.push_back(static_cast<int>(i)); }
    }
    return roots;
}

Result<std::vector<Affine>> jointsOf(const GltfFile& file, int index,
                                     const std::vector<Affine>& nodesToWorld) {
    const auto& skins = file.model.skins;
    if (static_cast<size_t>(index) >= skins.size()) {
        return file.error(fmt::format("there is no skin {}; the file has {}", index, skins.size()));
    }
    const tinygltf::Skin& skin = skins[static_cast<size_t>(index)];
    GltfNumbers inverses;
    if (skin.inverseBindMatrices >= 0) {
        auto read = readNumbers(file, skin.inverseBindMatrices, 16, 16, fmt::format("skin {}", index));
        if (!read) { return read.error(); }
        inverses = std::move(*read);
    }
    std::vector<Affine> joints;
    for (size_t i = 0; i < skin.joints.size(); ++i) {
        const auto node = static_cast<size_t>(std::max(skin.joints[i], 0));
        if (skin.joints[i] < 0 || node >= nodesToWorld.size()) {
            return file.error(fmt::format("skin {}: there is no node {}", index, skin.joints[i]));
        }
        Affine inverse;
        if (inverses.components > 0 && i < inverses.count()) {
            const float* m = inverses.at(i);
            inverse = {Mat3(m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]),
                       Vec3(m[12], m[13], m[14])};
        }
        joints.push_back(nodesToWorld[node] * inverse);
    }
    return joints;
}

std::optional<Light> lightOf(const tinygltf::Light& from, const Affine& toWorld) {
    Light light;
    light.name = from.name;
    light.kind = from.type == "directional" ? LightKind::Directional
                 : from.type == "spot"      ? LightKind::Spot
                                            : LightKind::Point;
    light.position = toWorld.translation;
    light.direction = toWorld.vector({0, 0, -1});
    if (isZero(light.direction) || !isFinite(light.direction) || !isFinite(light.position)) {
        return std::nullopt;
    }
    for (size_t c = 0; c < std::min<size_t>(3, from.color.size()); ++c) {
        light.color[static_cast<int>(c)] = clampf(static_cast<float>(from.color[c]), 0.0f, 1e6f);
    }
    light.strength = clampf(static_cast<float>(from.intensity / kLumensPerWatt), 0.0f, 1e18f);
    const auto degrees = [](double rad) {
        return clampf(static_cast<float>(rad * (180.0 / std::numbers::pi)), 0.0f, 90.0f);
    };
    light.coneAngleDeg = std::max(degrees(from.spot.outerConeAngle), 0.01f);
    light.coneFalloffStartDeg = std::min(degrees(from.spot.innerConeAngle), light.coneAngleDeg);
    return light;
}

}  // namespace glint
