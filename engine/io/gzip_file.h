// Files that may be packed by gzip. For the reader of pbrt scenes.
#pragma once

#include <string>

#include "engine/base/result.h"

namespace glint {

/// As readFile() (atomic_file.h), unpacked where the first bytes are gzip's, whatever the file's name. Error
/// also: broken or cut off, more than 1 GiB unpacked.
Result<std::string> readUnpacked(const std::string& path);

}  // namespace glint
