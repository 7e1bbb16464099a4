// Kinds of model and image files that Glint does not read, so that messages can name them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/base/result.h"

namespace glint {

/// That the file is of a kind which Glint does not read, or a picture, by its first bytes, or with `byName`
/// by its extension too.
std::optional<Error> foreignKindError(const std::string& path, std::string_view head, bool byName);

/// What is wrong with an image's file that is of no format which Glint reads.
std::string foreignImage(const std::string& path, std::string_view head);

}  // namespace glint
