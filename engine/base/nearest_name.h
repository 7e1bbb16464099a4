// "Unknown key 'colr'; did you mean 'color'?": the nearest of a list of known names.
//
// Not for anything per pixel.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace glint {

/// The known name that takes the fewest edits to reach, the first of equals; empty when none is near
/// enough to be a typing slip: more than a third of the longer name's length. An edit is one character
/// inserted, deleted or replaced, or two neighbours exchanged (optimal string alignment, Boytsov 2011);
/// case counts nothing.
std::string nearestName(std::string_view unknown, std::span<const std::string_view> known);

/// " (did you mean 'color'?)" with the nearest name, or an empty string: to append to an error message.
std::string didYouMean(std::string_view unknown, std::span<const std::string_view> known);

/// "a, b or c".
std::string joinNames(std::span<const std::string_view> names);

}  // namespace glint
