// An error with its place, its line and a mark under what is wrong, readable in any font and at any width.
#pragma once

#include "engine/base/result.h"

namespace glint {

/// Draws a framed box as wide as the column. Returns true when it was dismissed.
bool drawErrorBox(const char* title, const Error& error);

}  // namespace glint
