#include "engine/builders/profile_builder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/ext/vector_double2.hpp>

#include "engine/builders/profile_pieces.h"
#include "engine/math/bernstein.h"
#include "engine/scene/profile.h"

namespace glint {
namespace {

using Point = glm::dvec2;
static_assert(kHighestProfileDegree == kMaxProfileDegree);

ProfileCurve makeCurve(const Point* points, int degree) {
    ProfileCurve curve{};
    curve.degree = degree;
    for (int i = 0; i <= degree; ++i) {
        curve.x[i] = points[i].x;
        curve.y[i] = points[i].y;
    }
    return curve;
}

/// The volume between a curve and the axis over pi, the integral of x^2 dy: positive where the outside is to
/// the right of a curve that runs upwards.
double volumeOf(const ProfileCurve& curve) {
    constexpr int kSteps = 256;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double s = (i + 0.5) / kSteps;
        const double x = evaluateBernstein<kMaxProfileDegree>(curve.x, curve.degree, s).value;
        sum += x * x * evaluateBernstein<kMaxProfileDegree>(curve.y, curve.degree, s).derivative / kSteps;
    }
    return sum;
}

/// Area of the surface between two parameters of a curve, over 2 pi.
double ringOf(const ProfileCurve& curve, double begin, double end) {
    constexpr int kSteps = 32;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double s = begin + (end - begin) * (i + 0.5) / kSteps;
        const PolynomialValue x = evaluateBernstein<kMaxProfileDegree>(curve.x, curve.degree, s);
        const PolynomialValue y = evaluateBernstein<kMaxProfileDegree>(curve.y, curve.degree, s);
        sum += std::fabs(x.value) * std::hypot(x.derivative, y.derivative);
    }
    return sum * (end - begin) / kSteps;
}

/// Each step's share of the surface's area; returns that.
float tabulateArea(std::vector<ProfileCurve>* curves) {
    constexpr int kSteps = ProfileCurve::kAreaSteps;
    std::vector<double> before{0.0};
    for (const ProfileCurve& curve : *curves) {
        for (int step = 0; step < kSteps; ++step) {
            before.push_back(before.back() + ringOf(curve, static_cast<double>(step) / kSteps,
                                                    static_cast<double>(step + 1) / kSteps));
        }
    }
    const double all = before.back();
    for (size_t i = 0; i < curves->size(); ++i) {
        for (size_t step = 0; step <= kSteps; ++step) {
            (*curves)[i].areaBefore[step] =
                static_cast<float>(all > 0.0 ? before[i * kSteps + step] / all : 0.0);
        }
    }
    return static_cast<float>(2.0 * std::numbers::pi * all);
}

/// Discs where the profile ends off the axis, as straight curves between there and the axis.
void addCaps(std::vector<ProfileCurve>* curves) {
    const ProfileCurve first = curves->front(), last = curves->back();
    const Point begin(first.x[0], first.y[0]), end(last.x[last.degree], last.y[last.degree]);
    if (begin.x != 0.0) {
        const Point points[] = {{0.0, begin.y}, begin};
        ProfileCurve cap = makeCurve(points, 1);
        cap.vBegin = first.vBegin - first.vStep;
        cap.vStep = first.vStep;
        curves->insert(curves->begin(), cap);
    }
    if (end.x != 0.0) {
        const Point points[] = {end, {0.0, end.y}};
        ProfileCurve cap = makeCurve(points, 1);
        cap.vBegin = last.vBegin + last.vStep;
        cap.vStep = last.vStep;
        curves->push_back(cap);
    }
}

}  // namespace

ProfileView ProfileTable::view(size_t index) const {
    const ProfileData& data = profiles[index];
    return {&data, curves.data() + data.firstCurve, pieces.data() + data.firstPiece,
            groups.data() + data.firstGroup};
}

size_t ProfileTable::bytes() const {
    return profiles.size() * sizeof(ProfileData) + curves.size() * sizeof(ProfileCurve) +
           pieces.size() * sizeof(ProfilePiece) + groups.size() * sizeof(PieceGroup);
}

std::vector<ProfileCurve> profileCurvesOf(const Object& object) {
    const ProfileCurves shape = profileCurves(object);
    std::vector<ProfileCurve> curves;
    for (size_t i = 0; i < shape.count; ++i) {
        curves.push_back(makeCurve(bezierPoints(object, i).data(), shape.degree));
        curves.back().vBegin = 1.0f - static_cast<float>(i) / static_cast<float>(shape.count);
        curves.back().vStep = -1.0f / static_cast<float>(shape.count);
    }
    if (object.capped) { addCaps(&curves); }
    return curves;
}

uint32_t addProfile(const Object& object, ProfileTable* table) {
    std::vector<ProfileCurve> curves = profileCurvesOf(object);
    const Bounds box = profileBounds(object.profile);
    ProfileData data{};
    data.middle = 0.5 * (static_cast<double>(box.lo.y) + static_cast<double>(box.hi.y));
    data.halfHeight = 0.5 * (static_cast<double>(box.hi.y) - static_cast<double>(box.lo.y));
    data.radius = static_cast<double>(box.hi.x);
    data.firstCurve = static_cast<uint32_t>(table->curves.size());
    data.curveCount = static_cast<uint32_t>(curves.size());
    data.firstPiece = static_cast<uint32_t>(table->pieces.size());
    data.area = tabulateArea(&curves);
    double volume = 0.0;
    for (const ProfileCurve& curve : curves) {
        volume += volumeOf(curve);
    }
    data.front = volume < 0.0 ? -1.0f : 1.0f;
    data.clampsSearch = object.clampsSearch;
    data.firstGroup = static_cast<uint32_t>(table->groups.size());
    addPieces(curves, data, &table->pieces, &table->groups);
    data.pieceCount = static_cast<uint32_t>(table->pieces.size()) - data.firstPiece;
    table->curves.insert(table->curves.end(), curves.begin(), curves.end());
    table->profiles.push_back(data);
    return static_cast<uint32_t>(table->profiles.size() - 1);
}

}  // namespace glint
