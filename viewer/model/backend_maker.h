// What makes a further back end, for pictures beside the live one.
#pragma once

#include <functional>
#include <memory>

#include "engine/base/result.h"
#include "engine/render/backend.h"

namespace glint {

using BackendMaker = std::function<Result<std::unique_ptr<Backend>>()>;

}  // namespace glint
