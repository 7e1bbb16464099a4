// Fresnel reflectances, unpolarised and exact, and the directions of perfect reflection and refraction. Host
// and device.
#pragma once

#include "engine/math/vec.h"

namespace glint {

/// Reflectance of a boundary between dielectrics. cosIncident in [0, 1]; eta is the index of refraction
/// beyond the boundary over the one on the incident side, > 0. *cosTransmitted is the cosine of the refracted
/// direction to the boundary's far side, 0 under total internal reflection. Born and Wolf 1999,
/// section 1.5.2, eq. 32 to 35.
GLINT_HD inline float fresnelDielectric(float cosIncident, float eta, float* cosTransmitted) {
    const float sin2Incident = 1.0f - square(cosIncident);
    // Not 1 - sin^2 / eta^2: this is exact for eta = 1 and keeps its digits at grazing incidence.
    const float cos2Transmitted = square(cosIncident) + sin2Incident * (1.0f - 1.0f / square(eta));
    if (!(cos2Transmitted > 0.0f)) {
        *cosTransmitted = 0.0f;
        return 1.0f;
    }
    const float cosT = std::sqrt(cos2Transmitted);
    *cosTransmitted = cosT;
    // Both denominators are 0 only at grazing incidence with eta = 1: nothing is reflected there.
    const float parallel = (eta * cosIncident - cosT) / maxf(eta * cosIncident + cosT, 1e-20f);
    const float perpendicular = (cosIncident - eta * cosT) / maxf(cosIncident + eta * cosT, 1e-20f);
    return 0.5f * (square(parallel) + square(perpendicular));
}

/// Reflectance of a metal with index eta - i k seen from vacuum; cosIncident in [0, 1]. Born and Wolf 1999,
/// section 14.2, written with a^2 + b^2 = |sqrt((eta - ik)^2 - sin^2)|^2.
GLINT_HD inline float fresnelConductor(float cosIncident, float eta, float k) {
    const float cos2 = square(cosIncident);
    const float sin2 = 1.0f - cos2;
    const float difference = eta * eta - k * k - sin2;
    const float a2PlusB2 = std::sqrt(square(difference) + 4.0f * eta * eta * k * k);
    const float a = safeSqrt(0.5f * (a2PlusB2 + difference));
    const float sum = a2PlusB2 + cos2;
    const float cross = 2.0f * a * cosIncident;
    const float perpendicular = (sum - cross) / maxf(sum + cross, 1e-20f);
    const float sum2 = cos2 * a2PlusB2 + square(sin2);
    const float cross2 = cross * sin2;
    const float parallel = perpendicular * (sum2 - cross2) / maxf(sum2 + cross2, 1e-20f);
    return clampf(0.5f * (perpendicular + parallel), 0.0f, 1.0f);
}

GLINT_HD inline Vec3 fresnelConductor(float cosIncident, const Vec3& eta, const Vec3& k) {
    return {fresnelConductor(cosIncident, eta.x, k.x), fresnelConductor(cosIncident, eta.y, k.y),
            fresnelConductor(cosIncident, eta.z, k.z)};
}

/// Perfect reflection of w about the unit vector n.
GLINT_HD inline Vec3 reflect(const Vec3& w, const Vec3& n) { return 2.0f * glm::dot(w, n) * n - w; }

/// The refracted continuation of w, which points away from the surface on n's side: cosIncident = w . n > 0,
/// and cosTransmitted > 0 comes from fresnelDielectric() with the same eta. Unit length up to rounding.
GLINT_HD inline Vec3 refract(const Vec3& w, const Vec3& n, float eta, float cosIncident,
                             float cosTransmitted) {
    return (cosIncident / eta - cosTransmitted) * n - w / eta;
}

}  // namespace glint
