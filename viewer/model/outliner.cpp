#include "viewer/model/outliner.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include <fmt/format.h>

namespace glint {
namespace {

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// A part of the list: all things of a kind.
struct Part {
    OutlinerEntry::Kind kind;
    const char* what;
    size_t count;
    const std::string& (*nameOf)(const SceneDescription& scene, size_t index);
};

std::array<Part, 5> partsOf(const SceneDescription& scene) {
    using Kind = OutlinerEntry::Kind;
    using Scene = SceneDescription;
    using Name = const std::string&;
    return {{{Kind::Object, "Object", scene.objects.size(),
              [](const Scene& s, size_t i) -> Name { return s.objects[i].name; }},
             {Kind::Light, "Light", scene.lights.size(),
              [](const Scene& s, size_t i) -> Name { return s.lights[i].name; }},
             {Kind::Material, "Material", scene.materials.size(),
              [](const Scene& s, size_t i) -> Name { return s.materials[i].name; }},
             {Kind::Texture, "Texture", scene.textures.size(),
              [](const Scene& s, size_t i) -> Name { return s.textures[i].name; }},
             {Kind::Hidden, "Hidden", scene.hiddenObjects.size(),
              [](const Scene& s, size_t i) -> Name { return s.hiddenObjects[i].name; }}}};
}

}  // namespace

/// "Object 3: teapot"; the number makes it the only one.
OutlinerEntry Outliner::entryOf(size_t index) const {
    for (const Part& part : partsOf(*scene_)) {
        if (index >= part.count) {
            index -= part.count;
            continue;
        }
        ++labelsMade_;
        const std::string& name = part.nameOf(*scene_, index);
        std::string label = fmt::format("{} {}", part.what, index + 1);
        if (!name.empty()) { label += ": " + name; }
        return {part.kind, static_cast<int>(index), std::move(label)};
    }
    return {};
}

OutlinerEntry Outliner::at(size_t row) const { return entryOf(searched_.empty() ? row : found_[row]); }

size_t Outliner::count() const {
    size_t sum = 0;
    if (!scene_) { return sum; }
    for (const Part& part : partsOf(*scene_)) {
        sum += part.count;
    }
    return sum;
}

void Outliner::update(const SceneDocument& document) {
    if (document.posted() == scene_ && search == searched_) { return; }
    scene_ = document.posted();
    searched_ = search;
    found_.clear();
    if (searched_.empty()) { return; }
    const std::string wanted = lower(search);
    for (size_t i = 0; i < count(); ++i) {
        if (lower(entryOf(i).label).find(wanted) == std::string::npos) { continue; }
        found_.push_back(static_cast<uint32_t>(i));
    }
}

}  // namespace glint
