// Surfaces of revolution where finding roots is hard: rays along the axis, across it and along the surface,
// profiles with cusps, ends without speed, and crossings of the axis, sizes far from 1.
//
// The truth is the slow solver (revolved_truth.h). A case measures the share of rays whose hits are all there
// and no others, and how far their t are off, as a part of what float allows.
#include <cmath>

#include "engine/kernels/shapes/revolved.h"
#include "engine/math/rng.h"
#include "engine/stress/revolved_truth.h"
#include "engine/stress/stress_families.h"
#include "engine/stress/stress_scene.h"

namespace glint {
namespace {

/// Six numbers in [0, 1) of a ray's own.
std::array<float, 6> numbersOf(uint64_t ray) {
    std::array<float, 6> u;
    for (size_t k = 0; k < u.size(); ++k) {
        u[k] = uniformFloat(static_cast<uint32_t>(hashCounter(17, ray * u.size() + k) >> 32));
    }
    return u;
}

/// The ray number `index` against a profile.
using MakeRay = Ray (*)(const TestedProfile& profile, uint64_t index, float parameter);

StressCase raysCase(const std::string& grade, const std::string& extreme, const NamedProfile& profile,
                    float scale, MakeRay makeRay, float parameter) {
    StressCase c = namedCase("revolved", grade, extreme, "a slow solver in long double", 1e-9);
    c.run = [=](const StressEffort& effort) -> Result<StressOutcome> {
        const TestedProfile tested(profile.object(scale), static_cast<double>(scale));
        const uint32_t rays = effort.touchOnly ? 50 : effort.steps(20000, 1000);
        RevolvedTally tally;
        for (uint32_t i = 0; i < rays; ++i) {
            if (i % 1024 == 0 && effort.stopped()) { return Error{"the stability suite was stopped", {}}; }
            compareHits(tested, makeRay(tested, i, parameter), &tally);
        }
        StressOutcome outcome;
        outcome.values.push_back({1.0 - static_cast<double>(tally.wrong) / rays, 1.0, 0.0});
        outcome.values.push_back({1.0 + std::fmax(0.0, tally.largestError - 1.0), 1.0, 0.0});
        // Rays that graze are not judged; a case that skips most of its rays says nothing.
        outcome.values.push_back({tally.skipped < 3 * tally.rays / 4 ? 1.0 : 0.0, 1.0, 0.0});
        outcome.samples = rays;
        return outcome;
    };
    return c;
}

Ray randomRay(const TestedProfile& profile, uint64_t index, float reach) {
    return profile.ray(numbersOf(index), static_cast<double>(reach), 1.0f);
}

/// Through the profile's box, rising by `slope`.
Ray levelRay(const TestedProfile& profile, uint64_t index, float slope) {
    const std::array<float, 6> u = numbersOf(index);
    const float angle = kTwoPi * u[3];
    Ray ray = profile.ray(u, 3.0, 1.0f);
    const Vec3 to = ray.at(1.0f);
    ray.direction = Vec3(std::cos(angle), u[4] < 0.5f ? slope : -slope, std::sin(angle));
    ray.origin = to - static_cast<float>(3.0 * profile.size) * ray.direction;
    return ray;
}

/// Rising by `slope`, at the height of two curves' common end somewhere within twice the radius from
/// its middle.
Ray jointRay(const TestedProfile& profile, uint64_t index, float slope) {
    const std::array<float, 6> u = numbersOf(index);
    const auto& curves = profile.table.curves;
    // Not the last curve's end: on the axis, rays touch it to within rounding, which may count or not.
    const size_t joints = curves.size() - 1;
    const auto number = static_cast<size_t>(u[0] * static_cast<float>(joints));
    const ProfileCurve& curve = curves[number < joints ? number : 0];
    const auto radius = static_cast<float>(profile.table.profiles[0].radius);
    const float angle = kTwoPi * u[1];
    const Vec3 direction(std::cos(angle), slope, -std::sin(angle));
    const float beside = radius * u[2] * u[2];
    const Vec3 middle(-beside * direction.z, curve.y[curve.degree], beside * direction.x);
    return {middle + 4.0f * radius * (u[3] - 1.5f) * direction, direction};
}

/// Downwards but for a millionth, past the axis at a distance that shrinks to `least` of the radius.
Ray uprightRay(const TestedProfile& profile, uint64_t index, float least) {
    const std::array<float, 6> u = numbersOf(index);
    const auto reach = static_cast<float>(profile.table.profiles[0].radius) * std::pow(least, u[0]);
    const float angle = kTwoPi * u[1], turn = kTwoPi * u[2];
    return {Vec3(reach * std::cos(angle), 3.0 * profile.size, reach * std::sin(angle)),
            Vec3(1e-6f * std::cos(turn), -1.0f, 1e-6f * std::sin(turn))};
}

/// Along the surface, off it by up to `off` of the size either way.
Ray tangentRay(const TestedProfile& profile, uint64_t index, float off) {
    const std::array<float, 6> u = numbersOf(index);
    const auto& curves = profile.table.curves;
    const auto number = static_cast<uint32_t>(u[0] * static_cast<float>(curves.size()));
    Hit hit;
    hit.primitive = number < curves.size() ? number : 0;
    hit.barycentric = Vec2(u[1], 0.0f);
    const float angle = kTwoPi * u[2];
    const Vec3 side(std::cos(angle), 0.0f, -std::sin(angle));
    const ObjectPoint at = RevolvedShape::surface<0>(profile.table.view(0), hit, side);
    const Vec3 normal = normalizeOr(at.ng, side);
    const Vec3 along = Vec3(-std::sin(angle), 0.0f, -std::cos(angle));
    const float turn = kTwoPi * u[3];
    const Vec3 direction = std::cos(turn) * along + std::sin(turn) * glm::cross(normal, along);
    const auto size = static_cast<float>(profile.size);
    return {at.p + size * (off * (2.0f * u[4] - 1.0f) * normal - 3.0f * direction), direction};
}

}  // namespace

void addRevolvedCases(StressCases* cases) {
    for (const NamedProfile& profile : namedProfiles()) {
        const std::string name = profile.name;
        cases->push_back(raysCase(name, "random rays against: " + name, profile, 1.0f, randomRay, 10.0f));
        cases->push_back(raysCase(name + ", along it", "rays that all but touch: " + name, profile, 1.0f,
                                  tangentRay, 0.02f));
    }
    const NamedProfile& glass = namedProfiles()[5];
    for (const float slope : {0.0f, 1e-9f, 1e-6f, 1e-5f, 1e-4f, 1e-2f}) {
        cases->push_back(raysCase("slope " + gradeNumber(slope), "rays that rise by " + gradeNumber(slope),
                                  glass, 1.0f, levelRay, slope));
    }
    for (const float slope : {1e-8f, 1e-7f, 1.1e-6f, 1.1e-5f, 2e-5f}) {
        cases->push_back(raysCase("slope " + gradeNumber(slope) + " at a joint",
                                  "rays that rise by " + gradeNumber(slope) + " through a joint", glass, 1.0f,
                                  jointRay, slope));
    }
    for (const float least : {1e-2f, 1e-6f, 1e-12f}) {
        cases->push_back(raysCase("upright, " + gradeNumber(least) + " from the axis",
                                  "upright rays as close to the axis as " + gradeNumber(least), glass, 1.0f,
                                  uprightRay, least));
    }
    for (const float scale : {1e-12f, 1e-6f, 1e6f, 1e12f}) {
        cases->push_back(raysCase("size " + gradeNumber(scale), "a glass " + gradeNumber(scale) + " large",
                                  glass, scale, randomRay, 10.0f));
    }
    cases->push_back(
        raysCase("from 1e4 away", "rays from 1e4 times the size away", glass, 1.0f, randomRay, 1e4f));
}

}  // namespace glint
