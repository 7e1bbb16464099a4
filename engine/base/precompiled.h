// What most translation units read anyway, compiled once for each target: the standard library's large
// headers, GLM and fmt. Only other people's headers belong here, so that no edit of ours rebuilds everything.
//
// Targets name it in angle brackets: its text then holds no path, and a compiler cache serves every checkout.
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
