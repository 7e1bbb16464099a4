#include "viewer/model/outliner.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

namespace glint {
namespace {

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// "Object 3: teapot"; the number makes it the only one.
template <class Item>
void addAll(const std::vector<Item>& items, OutlinerEntry::Kind kind, const char* what,
            std::vector<OutlinerEntry>* out) {
    for (size_t i = 0; i < items.size(); ++i) {
        const std::string& name = items[i].name;
        out->push_back(
            {kind, static_cast<int>(i),
             name.empty() ? fmt::format("{} {}", what, i + 1) : fmt::format("{} {}: {}", what, i + 1, name)});
    }
}

}  // namespace

const std::vector<OutlinerEntry>& Outliner::entries(const SceneDocument& document) {
    if (document.posted() == scene_ && search == searched_) { return entries_; }
    scene_ = document.posted();
    searched_ = search;
    entries_.clear();
    addAll(scene_->objects, OutlinerEntry::Kind::Object, "Object", &entries_);
    addAll(scene_->lights, OutlinerEntry::Kind::Light, "Light", &entries_);
    addAll(scene_->materials, OutlinerEntry::Kind::Material, "Material", &entries_);
    addAll(scene_->textures, OutlinerEntry::Kind::Texture, "Texture", &entries_);
    addAll(scene_->hiddenObjects, OutlinerEntry::Kind::Hidden, "Hidden", &entries_);
    count_ = entries_.size();
    const std::string wanted = lower(search);
    std::erase_if(entries_, [&](const OutlinerEntry& entry) {
        return lower(entry.label).find(wanted) == std::string::npos;
    });
    return entries_;
}

}  // namespace glint
