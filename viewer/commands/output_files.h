// Outputs are checked before anything is rendered: an hour's work must not end with "no such folder".
#pragma once

#include <string>

#include "engine/base/result.h"

namespace glint {

/// Error: the folder does not exist or cannot be written to, or `path` is a folder. Leaves nothing behind.
Status checkWritable(const std::string& path);

}  // namespace glint
