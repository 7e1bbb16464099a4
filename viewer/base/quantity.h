// What people type into a field of numbers: fractions, and units that are converted to the field's own.
#pragma once

#include <string_view>

#include "engine/base/result.h"

namespace glint {

/// What stands behind the number in a printf format: "mm" of "%.1f mm", "%" of "%.2f %%"; "" where
/// nothing does.
std::string_view unitOfFormat(std::string_view format);

/// A number as parseNumber() (units.h) takes it, or a fraction such as "1/3", "1 1/3" and "-2/3"; behind it,
/// a unit of the field's kind or none, which is the field's own: "35 mm" in a field of metres is 0.035, "50
/// %" in one without unit 0.5. Error: what is wrong, as the end of a sentence, and which units there are.
Result<double> parseQuantity(std::string_view text, std::string_view fieldUnit);

}  // namespace glint
