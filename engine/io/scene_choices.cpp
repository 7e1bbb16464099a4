#include "engine/io/scene_choices.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/io/atomic_file.h"
#include "engine/io/file_kind.h"
#include "engine/io/gltf_file.h"
#include "engine/io/importer.h"
#include "engine/io/scene_names.h"

namespace glint {
namespace {

using Json = nlohmann::json;

/// Null where there is none.
const Json& memberOf(const Json& object, const char* key) {
    static const Json kNone;
    const auto found = object.is_object() ? object.find(key) : object.end();
    return object.is_object() && found != object.end() ? *found : kNone;
}

const Json& elementOf(const Json& array, const Json& index) {
    static const Json kNone;
    const bool isThere = array.is_array() && index.is_number_unsigned() && index.get<size_t>() < array.size();
    return isThere ? array[index.get<size_t>()] : kNone;
}

std::string nameOf(const Json& thing, size_t index) {
    const Json& name = memberOf(thing, "name");
    const std::string text = name.is_string() ? utf8Text(name.get_ref<const std::string&>()) : "";
    return text.empty() ? fmt::to_string(index) : text;
}

SceneChoices::Animation animationOf(const Json& animation, size_t index, const Json& accessors) {
    SceneChoices::Animation out{nameOf(animation, index)};
    bool isFirst = true;
    for (const Json& sampler : memberOf(animation, "samplers")) {
        const Json& times = elementOf(accessors, memberOf(sampler, "input"));
        const Json& least = elementOf(memberOf(times, "min"), 0u);
        const Json& most = elementOf(memberOf(times, "max"), 0u);
        if (!least.is_number() || !most.is_number()) { continue; }
        const auto begin = least.get<float>(), end = most.get<float>();
        out.beginSeconds = isFirst ? begin : std::min(out.beginSeconds, begin);
        out.endSeconds = isFirst ? end : std::max(out.endSeconds, end);
        isFirst = false;
    }
    return out;
}

}  // namespace

SceneChoices readSceneChoices(const std::string& path) {
    SceneChoices choices;
    if (!checkRegularFile(path, "a scene file")) { return choices; }
    const std::string head = readHead(path);
    if (!looksLikeGltf(head)) { return choices; }
    // Buffers behind it are of no use here.
    std::error_code failed;
    const uintmax_t fileBytes = std::filesystem::file_size(path, failed);
    if (failed || fileBytes > kMaxFileBytes) { return choices; }
    const std::string bytes = readHead(path, gltfJsonEnd(head, fileBytes));
    const Json file = Json::parse(gltfJsonText(bytes), nullptr, false);
    for (const Json& animation : memberOf(file, "animations")) {
        choices.animations.push_back(
            animationOf(animation, choices.animations.size(), memberOf(file, "accessors")));
    }
    const Json& extension = memberOf(memberOf(file, "extensions"), "KHR_materials_variants");
    for (const Json& variant : memberOf(extension, "variants")) {
        choices.variants.push_back(nameOf(variant, choices.variants.size()));
    }
    return choices;
}

const std::string* findParameter(const SceneParameters& parameters, std::string_view name) {
    const auto found = std::ranges::find(parameters, name, &SceneParameters::value_type::first);
    return found != parameters.end() ? &found->second : nullptr;
}

void setParameter(SceneParameters* parameters, const std::string& name, const std::string& value) {
    std::erase_if(*parameters, [&](const auto& each) { return each.first == name; });
    if (!value.empty()) { parameters->emplace_back(name, value); }
}

std::optional<double> numberIn(const std::string& text) {
    double number = 0.0;
    const char* end = text.data() + text.size();
    const auto [rest, failed] = std::from_chars(text.data(), end, number);
    return failed == std::errc() && rest == end && std::isfinite(number) ? std::optional(number)
                                                                         : std::nullopt;
}

std::optional<size_t> indexIn(std::span<const std::string> names, const std::string& wanted) {
    if (const auto found = std::ranges::find(names, wanted); found != names.end()) {
        return static_cast<size_t>(found - names.begin());
    }
    const std::optional<double> number = numberIn(wanted);
    return number && *number >= 0.0 && *number < static_cast<double>(names.size())
               ? std::optional(static_cast<size_t>(*number))
               : std::nullopt;
}

}  // namespace glint
