// Clear skies and the sun: Preetham, Shirley and Smits 1999, "A Practical Analytic Model for Daylight".
// Internal to the Mitsuba importer.
//
// Radiances are in Mitsuba's units of these emitters, W/(m^2 sr nm) against the equal-energy white
// (SpectrumRole::Emission), in linear Rec.709.
#pragma once

#include "engine/math/transform.h"
#include "engine/scene/image.h"

namespace glint {

class PreethamSky {
  public:
    /// Directions have y up; `sun` points to it. Turbidity is clamped to [1.7, 10], for which the model was
    /// fitted; a sun below the horizon counts as on it.
    PreethamSky(const Vec3& sun, float turbidity);

    /// What arrives from a unit direction; black below the horizon. Not negative.
    Vec3 radiance(const Vec3& direction) const;
    const Vec3& sun() const { return sun_; }
    /// Of the sun on a surface that faces it: a black body of 5778 K behind the air's Rayleigh scattering and
    /// its aerosols. Ozone, water and mixed gases are left out: below 5 % of what is visible.
    Vec3 sunIrradiance() const;

  private:
    struct Perez {
        double a, b, c, d, e;
        double at(double cosTheta, double gamma) const;
    };

    Vec3 sun_;
    double turbidity_, thetaSun_;
    Perez luminance_, x_, y_;
    double zenithLuminance_, zenithX_, zenithY_;
};

/// A latitude-longitude map as Glint lays them out of `sky` times skyScale, and the sun as a disc of
/// `sunRadiusDeg`, at least a pixel, that brings `sunIrradiance`. `fromWorld` maps to the sky's directions.
ImageF skyMap(const PreethamSky& sky, const Mat3& fromWorld, float skyScale, const Vec3& sunIrradiance,
              float sunRadiusDeg, int width);

struct SunTime {
    int year = 2010, month = 7, day = 10;
    double hour = 15.0;  ///< local time
    double latitudeDeg = 35.6894, longitudeDeg = 139.6917, timezone = 9.0;
};

/// Where the sun stands, to about half a degree: x points east, y up, -z north. Spencer 1971, "Fourier series
/// representation of the position of the sun".
Vec3 sunDirection(const SunTime& time);

}  // namespace glint
