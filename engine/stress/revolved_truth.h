// Where rays meet surfaces of revolution, slowly and surely, beside what the kernels find: for the stability
// suite and for tests.
//
// The solver knows nothing of the polynomial: at each parameter of the profile the ray meets the ring's
// cylinder twice, and a hit is where such a meeting has the ring's height. It walks the parameter in small
// steps and bisects in long double.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/builders/profile_builder.h"
#include "engine/math/ray.h"

namespace glint {

struct NamedProfile {
    const char* name;
    CurveKind curve;
    int degree;  ///< Object::curveDegree
    std::vector<Vec2> points;

    /// With all coordinates multiplied by `scale`.
    Object object(float scale = 1.0f) const;
};

/// About 1 large: straight, round, wavy, closed, crossing the axis, with cusps and ends of no speed.
const std::vector<NamedProfile>& namedProfiles();

class SlowRevolved {
  public:
    /// `steps` along each curve.
    SlowRevolved(const std::vector<ProfileCurve>& curves, int steps);

    /// All t within the ray's interval, rising.
    std::vector<long double> hits(const Ray& ray) const;

  private:
    struct Node {
        long double x, y;
    };
    const std::vector<ProfileCurve>& curves_;
    int steps_;
    std::vector<Node> nodes_;  ///< steps + 1 a curve
};

/// A surface for both.
struct TestedProfile {
    ProfileTable table;
    SlowRevolved slow;
    double size;  ///< what tolerances are parts of

    TestedProfile(const Object& object, double size);
    TestedProfile(const TestedProfile&) = delete;
    TestedProfile& operator=(const TestedProfile&) = delete;

    /// A ray into the profile's box from within `reach` times the size, of any length; the numbers in [0, 1).
    Ray ray(const std::array<float, 6>& u, double reach, float length) const;
};

struct RevolvedTally {
    int64_t rays = 0, hits = 0, wrong = 0;
    int64_t skipped = 0;        ///< where hits are within 0.008 of the size of each other: grazing rays
    double largestError = 0.0;  ///< of t, as a part of what it may be
    std::string firstWrong;

    void join(const RevolvedTally& other);
};

/// All hits along the ray, found one after the other as a renderer finds them, beside the slow ones. They may
/// differ by a millionth of the distance from the surface's middle to the ray's origin and to the hit.
void compareHits(const TestedProfile& profile, const Ray& ray, RevolvedTally* tally);

}  // namespace glint
