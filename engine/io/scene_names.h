// Names of things in scenes: of foreign files, which may be bytes of any kind, as text that every format can
// hold, and as keys that differ.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "engine/scene/scene.h"

namespace glint {

/// UTF-8: bytes that are none are taken for Latin-1, and a zero byte becomes U+FFFD.
std::string utf8Text(std::string_view bytes);

/// utf8Text() of all names, title and description. Paths stay as they are.
void makeNamesText(SceneDescription* scene);

/// The items' names, made different from each other and never empty.
template <class Item>
std::vector<std::string> uniqueNames(const std::vector<Item>& items, std::string_view what) {
    std::vector<std::string> names;
    std::set<std::string> taken;
    for (const Item& item : items) {
        const std::string base = item.name.empty() ? std::string(what) : item.name;
        std::string name = base;
        for (int i = 2; !taken.insert(name).second; ++i) {
            name = fmt::format("{} {}", base, i);
        }
        names.push_back(std::move(name));
    }
    return names;
}

}  // namespace glint
