#include "engine/render/white_balance.h"

namespace glint {
namespace {

using DVec2 = glm::dvec2;
using DVec3 = glm::dvec3;
using DMat3 = glm::dmat3;

/// Row by row, as books print them.
DMat3 rows(const DVec3& a, const DVec3& b, const DVec3& c) { return glm::transpose(DMat3(a, b, c)); }

/// IEC 61966-2-1 and the inverse of the same primaries and white.
DMat3 xyzOfRec709() {
    return rows({0.4123907993, 0.3575843394, 0.1804807884}, {0.2126390059, 0.7151686788, 0.0721923154},
                {0.0193308187, 0.1191947798, 0.9505321522});
}

DMat3 bradford() {
    return rows({0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296});
}

/// Krystek's, for 1000 to 15000 K.
DVec2 planckian(double t) {
    const double u = (0.860117757 + 1.54118254e-4 * t + 1.28641212e-7 * t * t) /
                     (1.0 + 8.42420235e-4 * t + 7.08145163e-7 * t * t);
    const double v = (0.317398726 + 4.22806245e-5 * t + 4.20481691e-8 * t * t) /
                     (1.0 - 2.89741816e-5 * t + 1.61456053e-7 * t * t);
    return {u, v};
}

/// Across the locus, to the side of green.
DVec2 greenwards(double t) {
    const DVec2 along = planckian(t + 1.0) - planckian(t - 1.0);
    return glm::normalize(DVec2(along.y, -along.x)) * (along.x < 0.0 ? 1.0 : -1.0);
}

DVec2 uvOfXyz(const DVec3& xyz) {
    return DVec2(4.0 * xyz.x, 6.0 * xyz.y) / (xyz.x + 15.0 * xyz.y + 3.0 * xyz.z);
}

/// Of luminance 1.
DVec3 xyzOfUv(const DVec2& uv) { return {1.5 * uv.x / uv.y, 1.0, (4.0 - uv.x - 10.0 * uv.y) / (2.0 * uv.y)}; }

}  // namespace

Mat3 whiteBalanceMatrix(const WhiteBalance& white) {
    if (white.isNeutral()) { return Mat3(1.0f); }
    const DMat3 toXyz = xyzOfRec709();
    const DVec3 d65 = toXyz * DVec3(1.0);
    const auto neutral = static_cast<double>(WhiteBalance{}.kelvin),
               kelvin = static_cast<double>(white.kelvin);
    // Where D65 lies from the locus, along it and across it.
    const DVec2 offset = uvOfXyz(d65) - planckian(neutral);
    const double across = glm::dot(offset, greenwards(neutral)) + 2e-4 * static_cast<double>(white.tint);
    const DVec2 along = offset - glm::dot(offset, greenwards(neutral)) * greenwards(neutral);
    const DVec3 light = xyzOfUv(planckian(kelvin) + along + across * greenwards(kelvin));
    const DVec3 gain = (bradford() * d65) / (bradford() * light);
    const DMat3 scaled = DMat3(DVec3(gain.x, 0.0, 0.0), DVec3(0.0, gain.y, 0.0), DVec3(0.0, 0.0, gain.z));
    return Mat3(glm::inverse(toXyz) * glm::inverse(bradford()) * scaled * bradford() * toXyz);
}

}  // namespace glint
