// Transforms of pbrt's directives, in double until all are joined.
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "engine/io/pbrt_state.h"

namespace glint {
namespace {

/// World to camera: z runs to the target, y as far up as it can, x to the right, which makes it left-handed.
glm::dmat4 lookAt(PbrtContext* context, const PbrtPlace& at, const std::vector<double>& n) {
    const glm::dvec3 eye(n[0], n[1], n[2]), forward = glm::dvec3(n[3], n[4], n[5]) - eye,
                                            up(n[6], n[7], n[8]);
    const glm::dvec3 right = glm::cross(up, forward);
    if (!(glm::length(right) > 1e-12 * glm::length(up) * glm::length(forward))) {
        context->fail(at, "the camera looks along its up vector, or nowhere");
        return glm::dmat4(1.0);
    }
    const glm::dvec3 z = glm::normalize(forward), x = glm::normalize(right), y = glm::cross(z, x);
    return glm::inverse(
        glm::dmat4(glm::dvec4(x, 0.0), glm::dvec4(y, 0.0), glm::dvec4(z, 0.0), glm::dvec4(eye, 1.0)));
}

}  // namespace

glm::dmat4 transformOf(PbrtContext* context, const PbrtPlace& at, std::string_view directive,
                       const std::vector<double>& n) {
    const glm::dmat4 identity(1.0);
    if (directive == "Translate") { return glm::translate(identity, glm::dvec3(n[0], n[1], n[2])); }
    if (directive == "Scale") { return glm::scale(identity, glm::dvec3(n[0], n[1], n[2])); }
    if (directive == "LookAt") { return lookAt(context, at, n); }
    if (directive == "Rotate") {
        const glm::dvec3 axis(n[1], n[2], n[3]);
        if (glm::length(axis) > 0.0) { return glm::rotate(identity, glm::radians(n[0]), axis); }
        context->fail(at, "the rotation has no axis; expected three numbers that are not all 0");
        return identity;
    }
    glm::dmat4 matrix;
    for (int i = 0; i < 16; ++i) {
        matrix[i / 4][i % 4] = n[static_cast<size_t>(i)];
    }
    return matrix;
}

Affine affineOf(PbrtContext* context, const PbrtPlace& at, const glm::dmat4& matrix) {
    Affine out;
    constexpr double kRounding = 1e-7;
    const double w = std::abs(matrix[3].w);
    bool isFine = w > 0.0;
    for (int column = 0; column < 3; ++column) {
        isFine = isFine && std::abs(matrix[column].w) <= kRounding * w;
    }
    for (int column = 0; column < 4; ++column) {
        const glm::dvec3 v = glm::dvec3(matrix[column]) / matrix[3].w;
        for (int row = 0; row < 3; ++row) {
            isFine = isFine && std::abs(v[row]) <= kMaxCoordinateD;
            (column < 3 ? out.linear[column][row] : out.translation[row]) = static_cast<float>(v[row]);
        }
    }
    if (!isFine) { context->fail(at, "the transform is not affine, or its numbers are above 1e18"); }
    return isFine ? out : Affine();
}

}  // namespace glint
