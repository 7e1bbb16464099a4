// Who renders, by name: what the commands' --backend option and the window's start choose from.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "engine/render/backend.h"

namespace glint {

/// "cpu" or "cuda". "cuda" falls back to the CPU where this build or this machine cannot do it, and logs one
/// warning that says why. `threads` are the CPU's, 0: all. Error: an unknown name, naming the nearest.
Result<std::unique_ptr<Backend>> makeBackend(std::string_view name, int threads);

}  // namespace glint
