// Transforms and vectors of Mitsuba's files, in double until all steps are joined.
#include <cmath>

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include "engine/io/mitsuba_object.h"

namespace glint {
namespace {

glm::dvec3 vectorOf(MitsubaContext* context, const MitsubaElement& at, double otherwise) {
    if (at.has("value")) {
        const auto v = mitsubaNumbers(context, at, at.attribute("value"), {1, 3});
        return v.size() == 3 ? glm::dvec3(v[0], v[1], v[2]) : glm::dvec3(v.empty() ? otherwise : v[0]);
    }
    glm::dvec3 out(otherwise);
    for (int i = 0; i < 3; ++i) {
        constexpr std::string_view kAxes[] = {"x", "y", "z"};
        if (at.has(kAxes[i])) { out[i] = mitsubaNumber(context, at, at.attribute(kAxes[i])); }
    }
    return out;
}

glm::dvec3 pointOf(MitsubaContext* context, const MitsubaElement& at, std::string_view name,
                   const glm::dvec3& otherwise) {
    if (!at.has(name)) { return otherwise; }
    const auto v = mitsubaNumbers(context, at, at.attribute(name), {3});
    return v.size() == 3 ? glm::dvec3(v[0], v[1], v[2]) : otherwise;
}

/// The local z axis points to the target, y as far up as it can, x to the left.
glm::dmat4 lookAt(MitsubaContext* context, const MitsubaElement& at) {
    const glm::dvec3 origin = pointOf(context, at, "origin", glm::dvec3(0.0));
    const glm::dvec3 forward = pointOf(context, at, "target", glm::dvec3(0.0, 0.0, 1.0)) - origin;
    glm::dvec3 up = pointOf(context, at, "up", glm::dvec3(0.0));
    if (glm::length(up) == 0.0) {
        up = std::abs(forward.y) < 0.99 * glm::length(forward) ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
    }
    const glm::dvec3 left = glm::cross(up, forward);
    if (!(glm::length(left) > 1e-12 * glm::length(up) * glm::length(forward))) {
        context->fail(at, "the camera looks along its up vector, or nowhere");
        return glm::dmat4(1.0);
    }
    const glm::dvec3 z = glm::normalize(forward), x = glm::normalize(left), y = glm::cross(z, x);
    return {glm::dvec4(x, 0.0), glm::dvec4(y, 0.0), glm::dvec4(z, 0.0), glm::dvec4(origin, 1.0)};
}

glm::dmat4 matrixOf(MitsubaContext* context, const MitsubaElement& at) {
    const auto v = mitsubaNumbers(context, at, at.attribute("value"), {9, 16});
    glm::dmat4 matrix(1.0);
    const int size = v.size() == 9 ? 3 : 4;
    for (size_t i = 0; i < v.size(); ++i) {
        matrix[static_cast<int>(i) % size][static_cast<int>(i) / size] = v[i];
    }
    return matrix;
}

glm::dmat4 stepOf(MitsubaContext* context, const MitsubaElement& at) {
    const glm::dmat4 identity(1.0);
    if (at.tag == "translate") { return glm::translate(identity, vectorOf(context, at, 0.0)); }
    if (at.tag == "scale") { return glm::scale(identity, vectorOf(context, at, 1.0)); }
    if (at.tag == "matrix") { return matrixOf(context, at); }
    if (at.tag == "lookat") { return lookAt(context, at); }
    if (at.tag == "rotate") {
        const glm::dvec3 axis = vectorOf(context, at, 0.0);
        const double angle = mitsubaNumber(context, at, at.attribute("angle"));
        if (!(glm::length(axis) > 0.0)) {
            context->fail(at, "the rotation has no axis; expected x, y and z that are not all 0");
            return identity;
        }
        return glm::rotate(identity, glm::radians(angle), axis);
    }
    context->fail(
        at, fmt::format("<{}> is no transform; expected translate, rotate, scale, lookat or matrix", at.tag));
    return identity;
}

}  // namespace

Vec3 mitsubaVector(MitsubaContext* context, const MitsubaElement& at, float otherwise) {
    return Vec3(vectorOf(context, at, static_cast<double>(otherwise)));
}

Affine mitsubaTransform(MitsubaContext* context, const MitsubaElement& transform) {
    if (transform.tag == "animation" && !transform.children.empty()) {
        context->remark(transform, "animations are left out: all stands as at their first time");
        return mitsubaTransform(context, transform.children.front());
    }
    glm::dmat4 all(1.0);
    for (const MitsubaElement& step : transform.children) {
        all = stepOf(context, step) * all;
    }
    Affine out;
    bool isFine = all[0].w == 0.0 && all[1].w == 0.0 && all[2].w == 0.0 && all[3].w != 0.0;
    for (int column = 0; column < 4; ++column) {
        const glm::dvec3 v = glm::dvec3(all[column]) / all[3].w;
        for (int row = 0; row < 3; ++row) {
            isFine = isFine && std::abs(v[row]) <= kMaxCoordinateD;
            (column < 3 ? out.linear[column][row] : out.translation[row]) = static_cast<float>(v[row]);
        }
    }
    if (!isFine) {
        context->fail(transform, "the transform is not affine, or its numbers are above 1e18");
        return {};
    }
    return out;
}

}  // namespace glint
