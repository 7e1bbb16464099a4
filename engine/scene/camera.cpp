// In double, so that the axes are right to the last bit of a float.
#include "engine/scene/camera.h"

#include <initializer_list>

namespace glint {
namespace {

/// v / |v|, also where |v|^2 overflows or underflows; zero stays zero.
glm::dvec3 unit(const glm::dvec3& v) {
    const double largest = std::fmax(std::fabs(v.x), std::fmax(std::fabs(v.y), std::fabs(v.z)));
    return largest > 0.0 ? glm::normalize(v / largest) : glm::dvec3(0.0);
}

/// Image right for a unit view direction.
glm::dvec3 rightOf(const glm::dvec3& view, const glm::dvec3& up) {
    // Less than this and `up` says nothing but rounding errors about which way is up.
    constexpr double kLeastSine = 1e-6;
    for (const glm::dvec3& candidate : {unit(up), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)}) {
        const glm::dvec3 right = glm::cross(view, candidate);
        if (glm::length(right) > kLeastSine) { return glm::normalize(right); }
    }
    return {1, 0, 0};  // unreachable: a view cannot be along both y and z
}

}  // namespace

CameraAxes axesOf(const Camera& camera) {
    glm::dvec3 view = unit(glm::dvec3(camera.target) - glm::dvec3(camera.position));
    if (view == glm::dvec3(0.0)) { view = glm::dvec3(0, 0, -1); }
    const glm::dvec3 right = rightOf(view, glm::dvec3(camera.up));
    return {Vec3(right), Vec3(glm::cross(right, view)), Vec3(view)};
}

}  // namespace glint
