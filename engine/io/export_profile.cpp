// Turned profiles as triangles, for programs that have no such surfaces.
#include <array>
#include <cmath>

#include "engine/io/scene_export.h"
#include "engine/math/bernstein.h"
#include "engine/scene/profile.h"

namespace glint {
namespace {

constexpr int kStepsAround = 128, kStepsAlong = 32;

/// A place on a profile, the derivative there, and the texture's v.
struct CurvePoint {
    Vec2 at, along;
    float v;
};

/// kStepsAlong + 1 places for each curve; caps are straight ones, whose v goes on beyond the profile's.
std::vector<CurvePoint> pointsOf(const Object& object) {
    const ProfileCurves curves = profileCurves(object);
    std::vector<CurvePoint> points;
    const auto addCurve = [&](const std::vector<glm::dvec2>& control, float vBegin) {
        std::array<double, kHighestProfileDegree + 1> x{}, y{};
        for (size_t i = 0; i < control.size(); ++i) {
            x[i] = control[i].x;
            y[i] = control[i].y;
        }
        const int degree = static_cast<int>(control.size()) - 1;
        for (int i = 0; i <= kStepsAlong; ++i) {
            const double s = static_cast<double>(i) / kStepsAlong;
            const PolynomialValue px = evaluateBernstein<kHighestProfileDegree>(x.data(), degree, s);
            const PolynomialValue py = evaluateBernstein<kHighestProfileDegree>(y.data(), degree, s);
            points.push_back({Vec2(glm::dvec2(px.value, py.value)),
                              Vec2(glm::dvec2(px.derivative, py.derivative)),
                              vBegin - static_cast<float>(s) / static_cast<float>(curves.count)});
        }
    };
    const glm::dvec2 first = bezierPoints(object, 0).front();
    const glm::dvec2 last = bezierPoints(object, curves.count - 1).back();
    const float step = 1.0f / static_cast<float>(curves.count);
    if (object.capped && first.x != 0.0) { addCurve({{0.0, first.y}, first}, 1.0f + step); }
    for (size_t curve = 0; curve < curves.count; ++curve) {
        addCurve(bezierPoints(object, curve), 1.0f - static_cast<float>(curve) * step);
    }
    if (object.capped && last.x != 0.0) { addCurve({last, {0.0, last.y}}, 0.0f); }
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
        const auto& [at, along, v] = points[row];
        for (int step = 0; step <= kStepsAround; ++step) {
            const float u = static_cast<float>(step) / kStepsAround, a = kTwoPi * u;
            mesh.positions.emplace_back(at.x * std::cos(a), at.y, -at.x * std::sin(a));
            const Vec3 normal = front * Vec3(along.y * std::cos(a), -along.x, -along.y * std::sin(a));
            mesh.normals.push_back(isZero(normal) ? Vec3(0, 1, 0) : glm::normalize(normal));
            mesh.uvs.emplace_back(u, v);
        }
    }
    constexpr uint32_t kColumns = kStepsAround + 1;
    for (uint32_t row = 0; row + 1 < rows; ++row) {
        if (row % (kStepsAlong + 1) == kStepsAlong) { continue; }  // where two curves meet
        for (uint32_t column = 0; column < kStepsAround; ++column) {
            const uint32_t a = row * kColumns + column, b = a + 1, c = a + kColumns, d = c + 1;
            const auto add = [&](uint32_t p, uint32_t q, uint32_t r) {
                mesh.indices.insert(mesh.indices.end(), {p, front > 0.0f ? q : r, front > 0.0f ? r : q});
            };
            if (points[row].at.x != 0.0f) { add(a, b, c); }  // on the axis a and b are one
            if (points[row + 1].at.x != 0.0f) { add(b, d, c); }
        }
    }
    return mesh;
}

}  // namespace glint
