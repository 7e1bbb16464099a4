// What copies are called.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace glint {

/// "ball copy" for "ball"; for that one, and for "ball" once more, "ball copy 2", and so on: one more than
/// the largest number that is `taken`. So names of copies of copies stay short.
std::string copyName(std::string_view name, const std::vector<std::string_view>& taken);

}  // namespace glint
