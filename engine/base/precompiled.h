// What most translation units read anyway, compiled once for each target: the standard library's large
// headers, GLM and fmt. Only other people's headers belong here, so that no edit of ours rebuilds everything.
//
// Every file still includes what it uses: the release preset does without, since GCC 12 at -O3 takes
// precompiled headers for our own code and reports overlapping copies in std::string that are none.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <glm/glm.hpp>
