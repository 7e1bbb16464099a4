// Vector types: GLM's, under the names the kernels use. Host and device.
//
// Points, directions and linear Rec.709 colours are all Vec3; names say which (pWorld, wiLocal, radiance).
#pragma once

#define GLM_FORCE_SILENT_WARNINGS
// Without the unions that give x a second name, GCC keeps vectors of structs in registers.
#define GLM_FORCE_XYZW_ONLY
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "engine/base/host_device.h"

namespace glint {

using Vec2 = glm::vec2;
using Vec3 = glm::vec3;
using Vec4 = glm::vec4;
using Vec2i = glm::ivec2;
using Mat3 = glm::mat3;  // column-major, as GLM's

constexpr float kPi = 3.14159265358979323846f;
constexpr float kInvPi = 0.31830988618379067154f;
constexpr float kTwoPi = 6.28318530717958647692f;
constexpr float kDegreesPerRadian = 180.0f / kPi;
constexpr double kPiD = std::numbers::pi;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

GLINT_HD inline float square(float x) { return x * x; }
GLINT_HD inline double square(double x) { return x * x; }
GLINT_HD inline float clampf(float x, float lo, float hi) { return x < lo ? lo : (x > hi ? hi : x); }
/// Not std::fmin and std::fmax, which keep numbers beside NaN and so are library calls on the host; these are
/// one instruction. Where a number is NaN the answer is b.
GLINT_HD inline float minf(float a, float b) { return a < b ? a : b; }
GLINT_HD inline float maxf(float a, float b) { return a > b ? a : b; }
GLINT_HD inline float absDot(const Vec3& a, const Vec3& b) { return std::fabs(glm::dot(a, b)); }
GLINT_HD inline float lengthSquared(const Vec3& v) { return glm::dot(v, v); }
GLINT_HD inline float maxComponent(const Vec3& v) { return maxf(v.x, maxf(v.y, v.z)); }
GLINT_HD inline float minComponent(const Vec3& v) { return minf(v.x, minf(v.y, v.z)); }
GLINT_HD inline bool isZero(const Vec3& v) { return v.x == 0.0f && v.y == 0.0f && v.z == 0.0f; }
GLINT_HD inline bool isFinite(const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
GLINT_HD inline Vec3 absVec(const Vec3& v) { return {std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}; }

/// sqrt that answers 0 for the slightly negative arguments that rounding produces.
GLINT_HD inline float safeSqrt(float x) { return x > 0.0f ? std::sqrt(x) : 0.0f; }

/// The bound of accumulated relative error after n float operations (Higham 2002, section 3.1): n eps / (1 -
/// n eps).
GLINT_HD constexpr float errorGamma(int n) {
    constexpr float kMachineEpsilon = 0x1p-24f;
    return (static_cast<float>(n) * kMachineEpsilon) / (1.0f - static_cast<float>(n) * kMachineEpsilon);
}

}  // namespace glint
