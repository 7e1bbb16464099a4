// Outputs are checked before anything is rendered: an hour's work must not end with "no such folder".
#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"

namespace glint {

/// checkWritable() of all that are not empty. Error also: two of them are one file.
Status checkAllWritable(const std::vector<std::string>& paths);

}  // namespace glint
