// What panels call what scene files have keys and words for.
#pragma once

#include <string>
#include <string_view>

namespace glint {

/// Of a key in scene files: "clearcoatRoughness" gives "Clearcoat roughness".
std::string inputLabel(std::string_view key);

/// A field's help as a tooltip begins: with a capital.
std::string inputTooltip(std::string_view help);

}  // namespace glint
