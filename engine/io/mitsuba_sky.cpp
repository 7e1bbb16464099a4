#include "engine/io/mitsuba_sky.h"

#include <algorithm>
#include <cmath>

#include "engine/io/spectrum_colors.h"

namespace glint {
namespace {

/// From kcd/m^2, by 683 lm/W and the integral of the observer's y, 106.857 nm.
constexpr double kPerKilocandela = 1000.0 / (683.002 * 106.857);
constexpr double kSunSolidAngle = 6.807e-5;

double polynomial(const double (&rows)[3][4], double t, double theta) {
    double sum = 0.0;
    const double powers[] = {t * t, t, 1.0};
    for (int i = 0; i < 3; ++i) {
        sum += powers[i] * (((rows[i][0] * theta + rows[i][1]) * theta + rows[i][2]) * theta + rows[i][3]);
    }
    return sum;
}

}  // namespace

double PreethamSky::Perez::at(double cosTheta, double gamma) const {
    const double cosGamma = std::cos(gamma);
    return (1.0 + a * std::exp(b / std::max(cosTheta, 1e-3))) *
           (1.0 + c * std::exp(d * gamma) + e * cosGamma * cosGamma);
}

PreethamSky::PreethamSky(const Vec3& sun, float turbidity)
    : sun_(glm::normalize(Vec3(sun.x, std::max(sun.y, 1e-4f), sun.z))),
      turbidity_(static_cast<double>(std::clamp(turbidity, 1.7f, 10.0f))),
      thetaSun_(std::acos(static_cast<double>(sun_.y))) {
    const double t = turbidity_, theta = thetaSun_;
    luminance_ = {0.1787 * t - 1.4630, -0.3554 * t + 0.4275, -0.0227 * t + 5.3251, 0.1206 * t - 2.5771,
                  -0.0670 * t + 0.3703};
    x_ = {-0.0193 * t - 0.2592, -0.0665 * t + 0.0008, -0.0004 * t + 0.2125, -0.0641 * t - 0.8989,
          -0.0033 * t + 0.0452};
    y_ = {-0.0167 * t - 0.2608, -0.0950 * t + 0.0092, -0.0079 * t + 0.2102, -0.0441 * t - 1.6537,
          -0.0109 * t + 0.0529};
    const double chi = (4.0 / 9.0 - t / 120.0) * (kPiD - 2.0 * theta);
    zenithLuminance_ = (4.0453 * t - 4.9710) * std::tan(chi) - 0.2155 * t + 2.4192;
    constexpr double kX[3][4] = {{0.00166, -0.00375, 0.00209, 0.0},
                                 {-0.02903, 0.06377, -0.03202, 0.00394},
                                 {0.11693, -0.21196, 0.06052, 0.25886}};
    constexpr double kY[3][4] = {{0.00275, -0.00610, 0.00317, 0.0},
                                 {-0.04214, 0.08970, -0.04153, 0.00516},
                                 {0.15346, -0.26756, 0.06670, 0.26688}};
    zenithX_ = polynomial(kX, t, theta);
    zenithY_ = polynomial(kY, t, theta);
}

Vec3 PreethamSky::radiance(const Vec3& direction) const {
    if (!(direction.y > 0.0f)) { return Vec3(0.0f); }
    const double cosTheta = static_cast<double>(direction.y);
    const double gamma = std::acos(std::clamp(static_cast<double>(glm::dot(direction, sun_)), -1.0, 1.0));
    const auto value = [&](double zenith, const Perez& perez) {
        return zenith * perez.at(cosTheta, gamma) / perez.at(1.0, thetaSun_);
    };
    const double luminance = kPerKilocandela * std::max(value(zenithLuminance_, luminance_), 0.0);
    const double x = value(zenithX_, x_), y = std::max(value(zenithY_, y_), 1e-3);
    return glm::max(rgbOfXyz({luminance * x / y, luminance, luminance * (1.0 - x - y) / y}), Vec3(0.0f));
}

Vec3 PreethamSky::sunIrradiance() const {
    const double elevationDeg = 90.0 - thetaSun_ * 180.0 / kPiD;
    const double airMass = 1.0 / (std::cos(thetaSun_) + 0.15 * std::pow(elevationDeg + 3.885, -1.253));
    const double aerosols = 0.04608 * turbidity_ - 0.04586;
    std::vector<SpectrumSample> spectrum;
    for (double nm = 360.0; nm <= 780.0; nm += 5.0) {
        const double micrometres = 1e-3 * nm;
        const double passes = std::exp(
            -airMass * (0.008735 * std::pow(micrometres, -4.08) + aerosols * std::pow(micrometres, -1.3)));
        spectrum.push_back({nm, kSunSolidAngle * passes * blackbodyRadiance(nm, 5778.0)});
    }
    return glm::max(rgbOfSpectrum(spectrum, SpectrumRole::Emission), Vec3(0.0f));
}

ImageF skyMap(const PreethamSky& sky, const Mat3& fromWorld, float skyScale, const Vec3& sunIrradiance,
              float sunRadiusDeg, int width) {
    constexpr int kSub = 8;
    const int height = width / 2;
    const auto directionAt = [&](float x, float y) {
        const float phi = (x / static_cast<float>(width) - 0.5f) * kTwoPi;
        const float theta = y / static_cast<float>(height) * kPi;
        return glm::normalize(fromWorld * Vec3(std::sin(theta) * std::sin(phi), std::cos(theta),
                                               -std::sin(theta) * std::cos(phi)));
    };
    const float pixel = kPi / static_cast<float>(height);
    const float radius = std::max(sunRadiusDeg * (kPi / 180.0f), 0.5f * pixel);
    ImageF map{width, height, {}};
    std::vector<std::pair<size_t, float>> disc;  // pixels, and how much of each is the sun's
    double solidAngle = 0.0;
    for (int y = 0; y < height; ++y) {
        const auto top = static_cast<float>(y);
        const double area = static_cast<double>((kTwoPi / static_cast<float>(width)) *
                                                (std::cos(top * pixel) - std::cos((top + 1.0f) * pixel)));
        for (int x = 0; x < width; ++x) {
            const auto left = static_cast<float>(x);
            const Vec3 direction = directionAt(left + 0.5f, top + 0.5f);
            const Vec3 color = skyScale * sky.radiance(direction);
            map.rgb.insert(map.rgb.end(), {color.x, color.y, color.z});
            if (glm::dot(direction, sky.sun()) < std::cos(radius + 2.0f * pixel)) { continue; }
            int within = 0;
            for (int i = 0; i < kSub * kSub; ++i) {
                const int column = i % kSub, row = i / kSub;
                const Vec3 at = directionAt(left + (static_cast<float>(column) + 0.5f) / kSub,
                                            top + (static_cast<float>(row) + 0.5f) / kSub);
                within += glm::dot(at, sky.sun()) >= std::cos(radius) ? 1 : 0;
            }
            if (within == 0) { continue; }
            disc.emplace_back(map.rgb.size() - 3, static_cast<float>(within) / (kSub * kSub));
            solidAngle += area * static_cast<double>(disc.back().second);
        }
    }
    for (const auto& [first, share] : disc) {
        for (int c = 0; c < 3; ++c) {
            map.rgb[first + static_cast<size_t>(c)] +=
                share * sunIrradiance[c] / static_cast<float>(solidAngle);
        }
    }
    return map;
}

Vec3 sunDirection(const SunTime& time) {
    constexpr int kDaysBefore[] = {0, 31, 59, 90, 120, 151, 181, 212, 243, 273, 304, 334};
    const int month = std::clamp(time.month, 1, 12);
    const bool isLeap = time.year % 4 == 0 && (time.year % 100 != 0 || time.year % 400 == 0);
    const int day = kDaysBefore[month - 1] + time.day + (isLeap && month > 2 ? 1 : 0);
    const double g = 2.0 * kPiD * (day - 1 + (time.hour - 12.0) / 24.0) / 365.0;
    const double declination = 0.006918 - 0.399912 * std::cos(g) + 0.070257 * std::sin(g) -
                               0.006758 * std::cos(2.0 * g) + 0.000907 * std::sin(2.0 * g) -
                               0.002697 * std::cos(3.0 * g) + 0.00148 * std::sin(3.0 * g);
    const double minutesAhead = 229.18 * (0.000075 + 0.001868 * std::cos(g) - 0.032077 * std::sin(g) -
                                          0.014615 * std::cos(2.0 * g) - 0.040849 * std::sin(2.0 * g));
    const double solarHour = time.hour + minutesAhead / 60.0 + time.longitudeDeg / 15.0 - time.timezone;
    const double hourAngle = (solarHour - 12.0) * kPiD / 12.0, latitude = time.latitudeDeg * kPiD / 180.0;
    const double up = std::sin(latitude) * std::sin(declination) +
                      std::cos(latitude) * std::cos(declination) * std::cos(hourAngle);
    const double east = -std::cos(declination) * std::sin(hourAngle);
    const double north = std::cos(latitude) * std::sin(declination) -
                         std::sin(latitude) * std::cos(declination) * std::cos(hourAngle);
    return Vec3(glm::dvec3(east, up, -north));
}

}  // namespace glint
