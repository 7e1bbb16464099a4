#include "engine/io/pbrt_color.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "engine/io/atomic_file.h"
#include "engine/math/color.h"
#include "engine/scene/glasses.h"
#include "engine/scene/metals.h"

namespace glint {
namespace {

struct Space {
    std::string_view name;
    PbrtColorSpace space;
    glm::dvec2 red, green, blue, white;  ///< chromaticities
};

constexpr glm::dvec2 kD65(0.3127, 0.3290);

// IEC 61966-2-1, ITU-R BT.2020, SMPTE ST 2065-1, and DCI-P3's primaries with the white of D65.
constexpr Space kSpaces[] = {
    {"srgb", PbrtColorSpace::Srgb, {0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, kD65},
    {"rec2020", PbrtColorSpace::Rec2020, {0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, kD65},
    {"aces2065-1",
     PbrtColorSpace::Aces2065,
     {0.7347, 0.2653},
     {0.0, 1.0},
     {0.0001, -0.077},
     {0.32168, 0.33767}},
    {"dci-p3", PbrtColorSpace::DciP3, {0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, kD65}};

glm::dvec3 xyzOf(const glm::dvec2& xy) { return {xy.x / xy.y, 1.0, (1.0 - xy.x - xy.y) / xy.y}; }

glm::dmat3 toXyz(const Space& space) {
    const glm::dmat3 primaries(xyzOf(space.red), xyzOf(space.green), xyzOf(space.blue));
    const glm::dvec3 weights = glm::inverse(primaries) * xyzOf(space.white);
    return {primaries[0] * weights.x, primaries[1] * weights.y, primaries[2] * weights.z};
}

/// Lam 1985, "Metamerism and Colour Constancy": the Bradford transform.
glm::dmat3 adaptation(const glm::dvec2& from, const glm::dvec2& to) {
    const glm::dmat3 cones =
        glm::transpose(glm::dmat3(0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296));
    const glm::dvec3 scale = (cones * xyzOf(to)) / (cones * xyzOf(from));
    return glm::inverse(cones) * glm::dmat3(scale.x, 0, 0, 0, scale.y, 0, 0, 0, scale.z) * cones;
}

struct NamedSpectrum {
    std::string_view name;
    std::string_view known;
};

constexpr NamedSpectrum kMetals[] = {{"metal-Ag", "silver"},
                                     {"metal-Al", "aluminium"},
                                     {"metal-Au", "gold"},
                                     {"metal-Cu", "copper"},
                                     {"metal-CuZn", "brass"}};
// pbrt's names first: its F5, F10 and F11 are SF5, SF10 and SF11.
constexpr NamedSpectrum kGlasses[] = {{"glass-BK7", "BK7"},   {"glass-LASF9", "LASF9"}, {"glass-F5", "SF5"},
                                      {"glass-F10", "SF10"},  {"glass-F11", "SF11"},    {"glass-SF5", "SF5"},
                                      {"glass-SF10", "SF10"}, {"glass-SF11", "SF11"}};

struct NamedColor {
    std::string_view name;
    Vec3 color;
};

// Indices at the sodium line: Schott's data sheets; of MgO and TiO2 (rutile) Bass 1995, "Handbook of Optics".
constexpr NamedColor kIndices[] = {{"glass-BAF10", Vec3(1.670f)},    {"glass-FK51A", Vec3(1.487f)},
                                   {"metal-MgO-eta", Vec3(1.737f)},  {"metal-MgO-k", Vec3(0.0f)},
                                   {"metal-TiO2-eta", Vec3(2.613f)}, {"metal-TiO2-k", Vec3(0.0f)}};

// Fluorescent lamps F1 to F12: CIE 15: 2004, table T.7.
constexpr glm::dvec2 kLamps[] = {{0.3131, 0.3371}, {0.3721, 0.3751}, {0.4091, 0.3941}, {0.4402, 0.4031},
                                 {0.3138, 0.3452}, {0.3779, 0.3882}, {0.3129, 0.3292}, {0.3458, 0.3586},
                                 {0.3741, 0.3727}, {0.3458, 0.3588}, {0.3805, 0.3769}, {0.4370, 0.4042}};

/// Planck's second constant has changed since the temperatures of daylight were named.
constexpr double kPlanckChange = 1.4388 / 1.4380;

/// Illuminants of daylight by their temperature: CIE 15: 2004, section 3.1.
glm::dvec2 daylight(double kelvin) {
    const double t = 1e3 / kelvin;
    const double x = kelvin <= 7000.0 ? ((-4.6070 * t + 2.9678) * t + 0.09911) * t + 0.244063
                                      : ((-2.0064 * t + 1.9018) * t + 0.24748) * t + 0.237040;
    return {x, (-3.0 * x + 2.870) * x - 0.275};
}

Vec3 ofLuminanceOne(const Vec3& color) {
    const float y = luminance(color);
    return y > 0.0f ? color / y : Vec3(0.0f);
}

/// "stdillum-D50", "stdillum-F2", "stdillum-A" and "illum-acesD60".
Vec3 namedIlluminant(const PbrtParams& params, std::string_view name) {
    if (name == "stdillum-A") { return ofLuminanceOne(rgbOfBlackbody(2856.0)); }
    if (name == "illum-acesD60") { return rgbOfXyz(xyzOf(kSpaces[2].white)); }
    constexpr size_t kPrefix = 10;
    size_t number = 0;
    if (name.size() > kPrefix) { std::from_chars(name.data() + kPrefix, name.data() + name.size(), number); }
    if (name.starts_with("stdillum-D") && number >= 40 && number <= 250) {
        return rgbOfXyz(xyzOf(daylight(100.0 * static_cast<double>(number) * kPlanckChange)));
    }
    if (name.starts_with("stdillum-F") && number >= 1 && number <= std::size(kLamps)) {
        return rgbOfXyz(xyzOf(kLamps[number - 1]));
    }
    params.context().remark(params.place(), "approximated: light of a lamp that is not known is white", name);
    return Vec3(1.0f);
}

Vec3 ofSamples(const PbrtParams& params, const PbrtPlace& at, const std::vector<double>& numbers,
               SpectrumRole role) {
    if (numbers.size() == 1) { return Vec3(static_cast<float>(numbers[0])); }
    const auto samples = spectrumOfPairs(numbers);
    if (!samples) {
        params.context().fail(at, std::string(kExpectedPairs));
        return {};
    }
    return rgbOfSpectrum(*samples, role == SpectrumRole::Emission ? role : SpectrumRole::Reflectance);
}

Vec3 ofFile(const PbrtParams& params, const PbrtParam& param, SpectrumRole role) {
    PbrtContext& context = params.context();
    Result<std::string> bytes = readFile(context.findFile(param.place, param.texts[0]));
    if (!bytes) {
        context.refuse(param.place, fmt::format("the spectrum \"{}\" is not known, and cannot be read: {}",
                                                param.texts[0], bytes.error().message));
        return Vec3(0.5f);
    }
    PbrtText text(std::move(*bytes), 0);
    std::vector<double> numbers;
    double number = 0.0;
    while (text.readNumber(&number)) {
        numbers.push_back(number);
    }
    if (!text.atEnd()) {
        context.fail(param.place, fmt::format("the spectrum \"{}\" holds what is no number", param.texts[0]));
        return {};
    }
    return ofSamples(params, param.place, numbers, role);
}

Vec3 namedSpectrum(const PbrtParams& params, const PbrtParam& param, SpectrumRole role) {
    const std::string& name = param.texts[0];
    if (name.starts_with("stdillum-") || name.starts_with("illum-")) { return namedIlluminant(params, name); }
    if (const auto metal = findMetal(pbrtMetal(name))) {
        return name.ends_with("-k") ? metal->k : metal->eta;
    }
    if (const auto glass = findGlass(pbrtGlass(name))) { return Vec3(glass->ior); }
    const auto index = std::ranges::find(kIndices, name, &NamedColor::name);
    return index != std::end(kIndices) ? index->color : ofFile(params, param, role);
}

Vec3 rawColor(const PbrtParams& params, const PbrtParam& param, SpectrumRole role) {
    const std::vector<float>& n = param.numbers;
    if (param.type == PbrtType::Spectrum && !param.texts.empty()) {
        return namedSpectrum(params, param, role);
    }
    if (param.type == PbrtType::Spectrum) {
        return ofSamples(params, param.place, std::vector<double>(n.begin(), n.end()), role);
    }
    if (param.type == PbrtType::Blackbody && !n.empty()) {  // pbrt-v3 has a scale behind it
        const float kelvin = std::clamp(n[0], 1.0f, 1e6f);
        return ofLuminanceOne(rgbOfBlackbody(static_cast<double>(kelvin))) * (n.size() > 1 ? n[1] : 1.0f);
    }
    if (param.type == PbrtType::Float && n.size() == 1) { return Vec3(n[0]); }
    if ((param.type == PbrtType::Rgb || param.type == PbrtType::Xyz) && n.size() == 3) {
        const Vec3 v(n[0], n[1], n[2]);
        return param.type == PbrtType::Xyz ? rgbOfXyz(glm::dvec3(v))
                                           : rgbOfSpace(params.colorSpace(), v, role);
    }
    params.context().fail(param.place, fmt::format("\"{}\" is no colour", param.name));
    return {};
}

}  // namespace

std::optional<PbrtColorSpace> pbrtColorSpace(std::string_view name) {
    const auto found = std::ranges::find(kSpaces, name, &Space::name);
    return found != std::end(kSpaces) ? std::optional(found->space) : std::nullopt;
}

Vec3 rgbOfSpace(PbrtColorSpace space, const Vec3& rgb, SpectrumRole role) {
    if (space == PbrtColorSpace::Srgb) { return rgb; }
    const Space& from = *std::ranges::find(kSpaces, space, &Space::space);
    const glm::dmat3 adapted =
        role == SpectrumRole::Emission ? glm::dmat3(1.0) : adaptation(from.white, kD65);
    return Vec3(glm::inverse(toXyz(kSpaces[0])) * adapted * toXyz(from) * glm::dvec3(rgb));
}

Mat3 pbrtWhiteBalance(double kelvin) {
    constexpr double kFirstDaylight = 4000.0;
    const glm::dmat3 fromRgb = toXyz(kSpaces[0]);
    glm::dvec2 white = daylight(kelvin * kPlanckChange);
    if (kelvin < kFirstDaylight) {
        const glm::dvec3 xyz = fromRgb * glm::dvec3(rgbOfBlackbody(kelvin));
        white = glm::dvec2(xyz) / (xyz.x + xyz.y + xyz.z);
    }
    return Mat3(glm::inverse(fromRgb) * adaptation(white, kD65) * fromRgb);
}

Vec3 pbrtColor(const PbrtParams& params, const PbrtParam& param, SpectrumRole role) {
    Vec3 color = rawColor(params, param, role);
    const bool isLight = role == SpectrumRole::Emission;
    if (isLight && param.type == PbrtType::Spectrum) { color = ofLuminanceOne(color); }
    const float least = role == SpectrumRole::Index ? 1e-4f : 0.0f;
    const Vec3 sane = glm::clamp(color, Vec3(least), Vec3(role == SpectrumRole::Reflectance ? 1.0f : 1e18f));
    if (glm::length(sane - color) > 1e-3f) {
        params.context().remark(param.place, role == SpectrumRole::Reflectance
                                                 ? std::string_view("reflectances beyond 0 to 1 are clamped")
                                                 : std::string_view("colours below 0 are clamped"));
    }
    return sane;
}

std::string_view pbrtMetal(std::string_view spectrum) {
    for (const std::string_view ending : {std::string_view("-eta"), std::string_view("-k")}) {
        if (!spectrum.ends_with(ending)) { continue; }
        const std::string_view metal = spectrum.substr(0, spectrum.size() - ending.size());
        const auto found = std::ranges::find(kMetals, metal, &NamedSpectrum::name);
        return found != std::end(kMetals) ? found->known : std::string_view();
    }
    return {};
}

std::string_view pbrtSpectrumOfGlass(std::string_view glass) {
    const auto found = std::ranges::find(kGlasses, glass, &NamedSpectrum::known);
    return found != std::end(kGlasses) ? found->name : std::string_view();
}

std::string_view pbrtGlass(std::string_view spectrum) {
    const auto found = std::ranges::find(kGlasses, spectrum, &NamedSpectrum::name);
    return found != std::end(kGlasses) ? found->known : std::string_view();
}

}  // namespace glint
