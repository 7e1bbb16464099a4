#include "engine/scene/metals.h"

#include <array>

namespace glint {
namespace {

struct NamedMetal {
    std::string_view name;
    MetalConstants constants;
};

// Measured n and k over 380 to 760 nm, linearly interpolated, each projected onto linear Rec.709 with the
// colour matching functions of Wyman, Sloan and Shirley 2013 and scaled so that a constant spectrum stays
// constant. The reflectance at normal incidence then agrees with that of the projected reflectance spectrum
// to 0.015 (gold's red to 0.04, which lies outside Rec.709). Sources of the measurements:
//   gold, silver, copper: Johnson and Christy 1972, Phys. Rev. B 6, 4370.
//   chromium, cobalt, iron, nickel, palladium, titanium: Johnson and Christy 1974, Phys. Rev. B 9, 5056.
//   aluminium: Rakic 1995, Appl. Opt. 34, 4755.
//   platinum, tungsten: Rakic, Djurisic, Elazar and Majewski 1998, Appl. Opt. 37, 5271 (Lorentz-Drude fit).
//   zinc: Werner, Glantschnig and Ambrosch-Draxl 2009, J. Phys. Chem. Ref. Data 38, 1013.
//   brass (70 % copper, 30 % zinc): Querry 1985, Contractor Report CRDC-CR-85034.
constexpr std::array<NamedMetal, 15> kMetals{{
    {"aluminium", {{1.4411f, 0.9885f, 0.5852f}, {7.5577f, 6.5662f, 5.3056f}}},
    {"aluminum", {{1.4411f, 0.9885f, 0.5852f}, {7.5577f, 6.5662f, 5.3056f}}},
    {"brass", {{0.4328f, 0.5141f, 1.1461f}, {3.5842f, 2.6946f, 1.7495f}}},
    {"chromium", {{3.2238f, 3.1178f, 2.2556f}, {3.2911f, 3.3387f, 3.1135f}}},
    {"cobalt", {{2.2297f, 2.0375f, 1.6985f}, {4.1803f, 3.7991f, 3.2137f}}},
    {"copper", {{0.2368f, 1.0373f, 1.2982f}, {3.2437f, 2.6013f, 2.3525f}}},
    {"gold", {{0.1077f, 0.4888f, 1.4780f}, {3.5087f, 2.3375f, 1.8090f}}},
    {"iron", {{2.9164f, 2.9216f, 2.5321f}, {3.0649f, 2.9396f, 2.7419f}}},
    {"nickel", {{2.0100f, 1.9041f, 1.7192f}, {4.1206f, 3.5751f, 2.8628f}}},
    {"palladium", {{1.7727f, 1.6229f, 1.3848f}, {4.2990f, 3.8168f, 3.1842f}}},
    {"platinum", {{2.3175f, 2.0770f, 1.8192f}, {4.1714f, 3.6728f, 3.0681f}}},
    {"silver", {{0.0554f, 0.0547f, 0.0427f}, {4.2930f, 3.5429f, 2.5342f}}},
    {"titanium", {{2.7158f, 2.5119f, 2.2269f}, {3.7912f, 3.4042f, 2.9993f}}},
    {"tungsten", {{3.6699f, 3.4450f, 3.3506f}, {2.9173f, 2.7368f, 2.5053f}}},
    {"zinc", {{1.1791f, 0.9140f, 0.6473f}, {5.7383f, 4.9240f, 3.8889f}}},
}};

}  // namespace

std::optional<MetalConstants> findMetal(std::string_view name) {
    for (const NamedMetal& metal : kMetals) {
        if (metal.name == name) { return metal.constants; }
    }
    return std::nullopt;
}

std::vector<std::string_view> metalNames() {
    std::vector<std::string_view> names;
    names.reserve(std::size(kMetals));
    for (const NamedMetal& metal : kMetals) {
        names.push_back(metal.name);
    }
    return names;
}

std::vector<std::string_view> listedMetals() {
    std::vector<std::string_view> names = metalNames();
    std::erase(names, "aluminum");
    return names;
}

Vec3 reflectanceHeadOn(const Material& metal) {
    const auto known = findMetal(metal.metal);
    const Vec3 eta = known ? known->eta : metal.eta.value, k = known ? known->k : metal.k.value;
    const Vec3 less = eta - Vec3(1.0f), more = eta + Vec3(1.0f);
    return (less * less + k * k) / (more * more + k * k);
}

}  // namespace glint
