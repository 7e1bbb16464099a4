#include "engine/scene/glasses.h"

#include <array>

namespace glint {
namespace {

struct NamedGlass {
    std::string_view name;
    float b[Dispersion::kTerms];
    float c[Dispersion::kTerms];  ///< square micrometres
};

constexpr float square(float x) { return x * x; }

// Terms of Sellmeier's formula, for air at room temperature. Sources:
//   BAK4, BK7, F2, LASF9, SF10, SF11, SF5, SK16: Schott AG, "Optical Glass Data Sheets" (the N- types but for
//   F2). acrylic: Sultanova, Kasarova and Nikolov 2009, Acta Phys. Pol. A 116, 585. cubic zirconia: Wood and
//   Nassau 1982, Appl. Opt. 21, 2978. diamond: Peter 1923, Z. Phys. 15, 358. fused silica: Malitson 1965, J.
//   Opt. Soc. Am. 55, 1205. sapphire (ordinary ray): Malitson and Dodge 1972, J. Opt. Soc. Am. 62, 1405.
//   water, 20 degrees: Daimon and Masumura 2007, Appl. Opt. 46, 3811.
constexpr std::array<NamedGlass, 14> kGlasses{{
    {"BAK4", {1.28834642f, 0.132817724f, 0.945395373f}, {0.00779980626f, 0.0315631177f, 105.965875f}},
    {"BK7", {1.03961212f, 0.231792344f, 1.01046945f}, {0.00600069867f, 0.0200179144f, 103.560653f}},
    {"F2", {1.34533359f, 0.209073176f, 0.937357162f}, {0.00997743871f, 0.0470450767f, 111.886764f}},
    {"LASF9", {2.00029547f, 0.298926886f, 1.80691843f}, {0.0121426017f, 0.0538736236f, 156.530829f}},
    {"SF10", {1.62153902f, 0.256287842f, 1.64447552f}, {0.0122241457f, 0.0595736775f, 147.468793f}},
    {"SF11", {1.73759695f, 0.313747346f, 1.89878101f}, {0.013188707f, 0.0623068142f, 155.23629f}},
    {"SF5", {1.52481889f, 0.187085527f, 1.42729015f}, {0.011254756f, 0.0588995392f, 129.141675f}},
    {"SK16", {1.34317774f, 0.241144399f, 0.994317969f}, {0.00704687339f, 0.0229005f, 92.7508526f}},
    {"acrylic", {1.1819f}, {0.011313f}},
    {"cubic zirconia",
     {1.347091f, 2.117788f, 9.452943f},
     {square(0.062543f), square(0.166739f), square(24.320570f)}},
    {"diamond", {0.3306f, 4.3356f}, {square(0.1750f), square(0.1060f)}},
    {"fused silica",
     {0.6961663f, 0.4079426f, 0.8974794f},
     {square(0.0684043f), square(0.1162414f), square(9.896161f)}},
    {"sapphire",
     {1.4313493f, 0.65054713f, 5.3414021f},
     {square(0.0726631f), square(0.1193242f), square(18.028251f)}},
    {"water",
     {0.5684027565f, 0.1726177391f, 0.02086189578f, 0.1130748688f},
     {0.005101829712f, 0.01821153936f, 0.02620722293f, 10.69792721f}},
}};

}  // namespace

std::optional<GlassConstants> findGlass(std::string_view name) {
    for (const NamedGlass& glass : kGlasses) {
        if (glass.name != name) { continue; }
        GlassConstants constants;
        constants.dispersion.formula = DispersionFormula::Sellmeier;
        for (int i = 0; i < Dispersion::kTerms; ++i) {
            constants.dispersion.b[i] = glass.b[i];
            constants.dispersion.c[i] = glass.c[i];
        }
        constants.ior = detail::sellmeierIndex(constants.dispersion, 1e-3f * kLineDNm);
        return constants;
    }
    return std::nullopt;
}

std::vector<std::string_view> glassNames() {
    std::vector<std::string_view> names;
    names.reserve(std::size(kGlasses));
    for (const NamedGlass& glass : kGlasses) {
        names.push_back(glass.name);
    }
    return names;
}

}  // namespace glint
