#include "viewer/model/edit_name.h"

#include <cctype>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "engine/scene/scene_diff.h"

namespace glint {
namespace {

struct PartName {
    std::string_view key;
    const char* one;
};

constexpr PartName kParts[] = {
    {"resolution", "Picture"}, {"camera", "Camera"},      {"render", "Render"},
    {"textures", "Texture"},   {"materials", "Material"}, {"meshes", "Mesh"},
    {"objects", "Object"},     {"lights", "Light"},       {"environment", "Environment"}};

const char* nameOfPart(std::string_view key) {
    for (const PartName& part : kParts) {
        if (part.key == key) { return part.one; }
    }
    const std::optional<IntegratorKind> owner = integratorByName(key);
    return owner ? integratorInfo(*owner).displayName : "Scene";
}

/// "aperture diameter" of "apertureDiameter". A unit at its end is left out.
std::string words(std::string_view key) {
    for (const std::string_view unit : {"Deg", "Pixels", "MiB"}) {
        if (key.ends_with(unit)) { key.remove_suffix(unit.size()); }
    }
    std::string text;
    for (const char letter : key) {
        const auto c = static_cast<unsigned char>(letter);
        if (std::isupper(c) != 0) { text += ' '; }
        text += static_cast<char>(std::tolower(c));
    }
    return text;
}

template <class Item>
std::string itemName(const std::vector<Item>& items, int index) {
    const std::string& name = items[static_cast<size_t>(index)].name;
    return name.empty() ? std::to_string(index + 1) : name;
}

std::string itemName(const SceneDescription& scene, const SceneDifference& at) {
    if (at.item < 0) { return ""; }
    if (at.part == "textures") { return " " + itemName(scene.textures, at.item); }
    if (at.part == "materials") { return " " + itemName(scene.materials, at.item); }
    if (at.part == "meshes") { return " " + itemName(scene.meshes, at.item); }
    if (at.part == "objects") { return " " + itemName(scene.objects, at.item); }
    if (at.part == "lights") { return " " + itemName(scene.lights, at.item); }
    return "";
}

}  // namespace

std::string editName(const SceneDescription& before, const SceneDescription& after) {
    const std::vector<SceneDifference> all = listDifferences(before, after);
    if (all.empty()) { return "Edit"; }
    const SceneDifference& first = all.front();
    for (const SceneDifference& each : all) {
        if (each.added == 0) { continue; }
        const int count = std::abs(each.added);
        const char* verb = each.added > 0 ? "added" : "removed";
        return count == 1 ? fmt::format("{} {}", nameOfPart(each.part), verb)
                          : fmt::format("{}: {} {}", nameOfPart(each.part), count, verb);
    }
    std::string fields;
    size_t more = 0;
    for (const SceneDifference& each : all) {
        const bool isOfFirst = each.part == first.part && each.item == first.item;
        if (isOfFirst && fields.empty()) {
            fields = words(each.key);
        } else {
            ++more;
        }
    }
    if (more > 0) { fields += fmt::format(" and {} more", more); }
    const std::string owner = nameOfPart(first.part) + itemName(after, first);
    return fields.empty() ? owner : fmt::format("{}: {}", owner, fields);
}

}  // namespace glint
