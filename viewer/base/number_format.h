// How a number is shown in a field that has a format of its own: so that what is seen is never taken for
// another number.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace glint {

/// `format`, of printf for one float, or the same with significant digits in place of its decimals: where
/// these would show less than two digits of a `value` that is not 0, and where the text is wider than its
/// field, so that its end would be cut off. An angle, and a number that is lost in the rounding of
/// `neighbours` (the largest size of the numbers beside it; 0: none are), is shown as 0 where its decimals
/// show none.
std::string formatThatShows(std::string_view format, float value, float neighbours,
                            const std::function<bool(const char* text)>& fits);

}  // namespace glint
