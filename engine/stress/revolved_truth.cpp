#include "engine/stress/revolved_truth.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/kernels/shapes/revolved.h"

namespace glint {
namespace {

using Real = long double;

constexpr int kSteps = 800;
constexpr int kFiner = 32;  ///< times as many, where the two differ

Real valueOf(const double* coefficients, int degree, Real s) {
    Real b[kMaxProfileDegree + 1] = {};
    std::copy(coefficients, coefficients + degree + 1, b);
    for (int left = degree; left > 0; --left) {
        for (int i = 0; i < left; ++i) {
            b[i] += s * (b[i + 1] - b[i]);
        }
    }
    return b[0];
}

template <class Function>
Real bisect(const Function& f, Real a, Real b) {
    const bool negative = f(a) < 0.0L;
    for (int i = 0; i < 80; ++i) {
        const Real c = 0.5L * (a + b);
        ((f(c) < 0.0L) == negative ? a : b) = c;
    }
    return 0.5L * (a + b);
}

/// One ray against the ring's cylinders.
struct SlowRay {
    Real oy, dy, flat2, middle, nearest2;

    explicit SlowRay(const Ray& ray)
        : oy(static_cast<Real>(ray.origin.y)), dy(static_cast<Real>(ray.direction.y)) {
        const Real ox = static_cast<Real>(ray.origin.x), oz = static_cast<Real>(ray.origin.z);
        const Real dx = static_cast<Real>(ray.direction.x), dz = static_cast<Real>(ray.direction.z);
        flat2 = dx * dx + dz * dz;
        middle = -(ox * dx + oz * dz) / flat2;
        const Real across = ox * dz - oz * dx;
        nearest2 = across * across / flat2;
    }
    Real room(Real x) const { return x * x - nearest2; }
    Real t(int side, Real x) const {
        return middle + static_cast<Real>(side) * std::sqrt(std::max<Real>(0.0L, room(x)) / flat2);
    }
    Real miss(int side, Real x, Real y) const { return y - oy - t(side, x) * dy; }
};

/// Hits that are clear of each other, so that a grazing ray is not asked for.
bool isClear(const std::vector<Real>& hits, double gap) {
    for (size_t i = 1; i < hits.size(); ++i) {
        if (hits[i] - hits[i - 1] < 4.0L * static_cast<Real>(gap)) { return false; }
    }
    return true;
}

std::vector<double> fastHits(const ProfileView& profile, Ray ray, double gap) {
    std::vector<double> hits;
    Hit hit;
    while (hits.size() < 64 && RevolvedShape::intersect<false, false>(profile, ray, &hit)) {
        hits.push_back(static_cast<double>(hit.t));
        ray.tMin = static_cast<float>(static_cast<double>(hit.t) + gap);
    }
    return hits;
}

/// The largest difference as a part of what it may be; infinite where there are more hits or less.
double difference(const std::vector<Real>& slow, const std::vector<double>& fast, double reach) {
    if (fast.size() != slow.size()) { return HUGE_VAL; }
    double most = 0.0;
    for (size_t i = 0; i < slow.size(); ++i) {
        // t is rounded to a float, and the origin's digits end where they end.
        const auto t = static_cast<double>(slow[i]);
        most = std::max(most, std::fabs(fast[i] - t) / (1e-6 * (std::fabs(t) + reach)));
    }
    return most;
}

template <class Number>
std::string listed(const std::vector<Number>& numbers) {
    std::string text;
    for (const Number t : numbers) {
        text += fmt::format(" {:.7g}", static_cast<double>(t));
    }
    return text;
}

}  // namespace

Object NamedProfile::object(float scale) const {
    Object object;
    object.shape = ShapeKind::Revolved;
    object.curve = curve;
    object.curveDegree = degree;
    for (const Vec2& p : points) {
        object.profile.push_back(scale * p);
    }
    return object;
}

SlowRevolved::SlowRevolved(const std::vector<ProfileCurve>& curves, int steps)
    : curves_(curves), steps_(steps) {
    for (const ProfileCurve& curve : curves) {
        for (int i = 0; i <= steps; ++i) {
            const Real s = static_cast<Real>(i) / steps;
            nodes_.push_back({valueOf(curve.x, curve.degree, s), valueOf(curve.y, curve.degree, s)});
        }
    }
}

std::vector<Real> SlowRevolved::hits(const Ray& ray) const {
    const SlowRay slow(ray);
    std::vector<Real> found;
    const Node* node = nodes_.data();
    for (const ProfileCurve& curve : curves_) {
        const auto xAt = [&](Real s) { return valueOf(curve.x, curve.degree, s); };
        const auto yAt = [&](Real s) { return valueOf(curve.y, curve.degree, s); };
        for (int i = 0; i < steps_; ++i, ++node) {
            const bool roomA = slow.room(node[0].x) >= 0.0L, roomB = slow.room(node[1].x) >= 0.0L;
            if (!roomA && !roomB) { continue; }
            Real a = static_cast<Real>(i) / steps_, b = static_cast<Real>(i + 1) / steps_;
            Node first = node[0], last = node[1];
            if (roomA != roomB) {
                const Real edge = bisect([&](Real s) { return slow.room(xAt(s)); }, a, b);
                (roomA ? b : a) = edge;
                (roomA ? last : first) = {xAt(edge), yAt(edge)};
            }
            for (const int side : {-1, 1}) {
                if ((slow.miss(side, first.x, first.y) < 0.0L) == (slow.miss(side, last.x, last.y) < 0.0L)) {
                    continue;
                }
                const Real s = bisect([&](Real at) { return slow.miss(side, xAt(at), yAt(at)); }, a, b);
                found.push_back(slow.t(side, xAt(s)));
            }
        }
        ++node;
    }
    std::erase_if(
        found, [&](Real t) { return !(t > static_cast<Real>(ray.tMin) && t < static_cast<Real>(ray.tMax)); });
    std::ranges::sort(found);
    return found;
}

TestedProfile::TestedProfile(const Object& object, double sizeOf)
    : table([&] {
          ProfileTable made;
          addProfile(object, &made);
          return made;
      }()),
      slow(table.curves, kSteps),
      size(sizeOf) {}

Ray TestedProfile::ray(const std::array<float, 6>& u, double reach, float length) const {
    const ProfileData& data = table.profiles[0];
    const auto middle = static_cast<float>(data.middle);
    const Vec3 half(data.radius, data.halfHeight, data.radius);
    const Vec3 to =
        Vec3(0, middle, 0) + half * Vec3(2.0f * u[0] - 1.0f, 2.0f * u[1] - 1.0f, 2.0f * u[2] - 1.0f);
    const Vec3 from =
        static_cast<float>(reach * size) * Vec3(2.0f * u[3] - 1.0f, 2.0f * u[4] - 1.0f, 2.0f * u[5] - 1.0f);
    return {from, (to - from) * length, 0.0f, kInfinity};
}

void RevolvedTally::join(const RevolvedTally& other) {
    if (wrong == 0) { firstWrong = other.firstWrong; }
    rays += other.rays;
    hits += other.hits;
    wrong += other.wrong;
    skipped += other.skipped;
    largestError = std::max(largestError, other.largestError);
}

void compareHits(const TestedProfile& profile, const Ray& ray, RevolvedTally* tally) {
    const double length = static_cast<double>(glm::length(ray.direction));
    const double gap = 2e-3 * profile.size / length;
    const double reach = (static_cast<double>(glm::length(ray.origin)) + profile.size) / length;
    std::vector<Real> slow = profile.slow.hits(ray);
    const std::vector<double> fast = fastHits(profile.table.view(0), ray, gap);
    double off = difference(slow, fast, reach);
    if (off > 1.0) {
        slow = SlowRevolved(profile.table.curves, kFiner * kSteps).hits(ray);
        off = difference(slow, fast, reach);
    }
    ++tally->rays;
    if (!isClear(slow, gap)) {
        ++tally->skipped;
        return;
    }
    tally->hits += static_cast<int64_t>(slow.size());
    tally->largestError = std::max(tally->largestError, std::min(off, 1e30));
    if (!(off > 1.0)) { return; }
    if (++tally->wrong == 1) {
        tally->firstWrong = fmt::format("origin {} {} {}, direction {} {} {}: expected{}; found{}",
                                        ray.origin.x, ray.origin.y, ray.origin.z, ray.direction.x,
                                        ray.direction.y, ray.direction.z, listed(slow), listed(fast));
    }
}

}  // namespace glint
