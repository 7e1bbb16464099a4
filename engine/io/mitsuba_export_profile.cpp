// Turned profiles as triangles, for programs that have no such surfaces.
#include <array>
#include <cmath>

#include "engine/io/mitsuba_writer.h"
#include "engine/scene/profile.h"

namespace glint {
namespace {

constexpr int kStepsAround = 128, kStepsAlong = 32;

/// One curve of a profile at s in [0, 1]: its point, and its derivative.
struct CurvePoint {
    Vec2 at, along;
};

CurvePoint bezierAt(const Vec2* points, int degree, float s) {
    std::vector<Vec2> p(points, points + degree + 1);
    for (size_t left = p.size() - 1; left > 1; --left) {
        for (size_t i = 0; i < left; ++i) {
            p[i] = glm::mix(p[i], p[i + 1], s);
        }
    }
    return {glm::mix(p[0], p[1], s), static_cast<float>(degree) * (p[1] - p[0])};
}

CurvePoint bsplineAt(const Vec2* p, float s) {
    const float t = 1.0f - s;
    const Vec2 at = (t * t * t * p[0] + (3.0f * s * s * s - 6.0f * s * s + 4.0f) * p[1] +
                     (-3.0f * s * s * s + 3.0f * s * s + 3.0f * s + 1.0f) * p[2] + s * s * s * p[3]) /
                    6.0f;
    const Vec2 along = 0.5f * (-t * t * p[0] + (3.0f * s * s - 4.0f * s) * p[1] +
                               (-3.0f * s * s + 2.0f * s + 1.0f) * p[2] + s * s * p[3]);
    return {at, along};
}

std::vector<CurvePoint> pointsOf(const Object& object) {
    const ProfileCurves curves = profileCurves(object);
    std::vector<CurvePoint> points;
    for (size_t curve = 0; curve < curves.count; ++curve) {
        const bool isSpline = object.curve == CurveKind::Bspline;
        const Vec2* first = &object.profile[isSpline ? curve : curve * static_cast<size_t>(curves.degree)];
        for (int i = 0; i <= kStepsAlong; ++i) {
            const float s = static_cast<float>(i) / kStepsAlong;
            points.push_back(isSpline ? bsplineAt(first, s) : bezierAt(first, curves.degree, s));
        }
    }
    return points;
}

}  // namespace

/// The front is outside: away from the volume between the curve and the axis.
MeshData turnedMesh(const Object& object) {
    const std::vector<CurvePoint> points = pointsOf(object);
    float volume = 0.0f;
    for (size_t i = 1; i < points.size(); ++i) {
        volume += square(points[i].at.x + points[i - 1].at.x) * (points[i].at.y - points[i - 1].at.y);
    }
    const float front = volume < 0.0f ? -1.0f : 1.0f;
    MeshData mesh;
    const auto rows = static_cast<uint32_t>(points.size());
    for (uint32_t row = 0; row < rows; ++row) {
        const auto& [at, along] = points[row];
        for (int step = 0; step <= kStepsAround; ++step) {
            const float u = static_cast<float>(step) / kStepsAround, a = kTwoPi * u;
            mesh.positions.emplace_back(at.x * std::cos(a), at.y, -at.x * std::sin(a));
            const Vec3 normal = front * Vec3(along.y * std::cos(a), -along.x, -along.y * std::sin(a));
            mesh.normals.push_back(isZero(normal) ? Vec3(0, 1, 0) : glm::normalize(normal));
            mesh.uvs.emplace_back(u, 1.0f - static_cast<float>(row) / static_cast<float>(rows - 1));
        }
    }
    constexpr uint32_t kColumns = kStepsAround + 1;
    for (uint32_t row = 0; row + 1 < rows; ++row) {
        if (row % (kStepsAlong + 1) == kStepsAlong) { continue; }  // where two curves meet
        for (uint32_t column = 0; column < kStepsAround; ++column) {
            const uint32_t a = row * kColumns + column, b = a + 1, c = a + kColumns, d = c + 1;
            const std::array<uint32_t, 6> corners =
                front > 0.0f ? std::array{a, b, c, b, d, c} : std::array{a, c, b, b, c, d};
            mesh.indices.insert(mesh.indices.end(), corners.begin(), corners.end());
        }
    }
    return mesh;
}

}  // namespace glint
