// Colours as Mitsuba's files write them.
#include <algorithm>

#include <fmt/format.h>

#include "engine/io/atomic_file.h"
#include "engine/io/mitsuba_spectrum.h"
#include "engine/math/color.h"

namespace glint {
namespace {

Vec3 sane(MitsubaContext* context, const MitsubaElement& at, const Vec3& color, SpectrumRole role) {
    const float most = role == SpectrumRole::Reflectance ? 1.0f : 1e18f;
    const Vec3 sane = glm::clamp(color, Vec3(0.0f), Vec3(most));
    if (glm::length(sane - color) > 1e-4f) {
        context->remark(at, role == SpectrumRole::Reflectance
                                ? std::string_view("reflectances beyond 0 to 1 are clamped")
                                : std::string_view("colours below 0 are clamped"));
    }
    return sane;
}

Vec3 hexColor(MitsubaContext* context, const MitsubaElement& at, std::string_view hex) {
    uint32_t value = 0;
    const bool isHex = hex.size() == 6 && std::ranges::all_of(hex, [](char c) {
                           return (c >= '0' && c <= '9') || ((c | 32) >= 'a' && (c | 32) <= 'f');
                       });
    if (!isHex) {
        context->fail(at, fmt::format("\"#{}\" is no colour; expected #rrggbb", hex.substr(0, 40)));
        return {};
    }
    for (const char c : hex) {
        value = 16 * value + static_cast<uint32_t>(c <= '9' ? c - '0' : (c | 32) - 'a' + 10);
    }
    const auto channel = [value](int shift) {
        return srgbToLinear(static_cast<float>(value >> shift & 255u) / 255.0f);
    };
    return {channel(16), channel(8), channel(0)};
}

/// "400:0.1, 500:0.2", or the lines of a file.
Vec3 listedSpectrum(MitsubaContext* context, const MitsubaElement& at, std::string list, SpectrumRole role) {
    std::ranges::replace(list, ':', ' ');
    const std::vector<double> numbers = mitsubaNumbers(context, at, list, {});
    const auto samples = spectrumOfPairs(numbers);
    if (!samples) {
        context->fail(at, std::string(kExpectedPairs));
        return {};
    }
    return sane(context, at, rgbOfSpectrum(*samples, role), role);
}

Vec3 fileSpectrum(MitsubaContext* context, const MitsubaElement& at, SpectrumRole role) {
    const Result<std::string> bytes = readFile(context->xml.findFile(at, at.attribute("filename")));
    if (!bytes) {
        context->fail(at,
                      fmt::format("cannot read \"{}\": {}", at.attribute("filename"), bytes.error().message));
        return {};
    }
    std::string text;
    bool isComment = false;
    for (const char c : *bytes) {
        isComment = c == '#' || (isComment && c != '\n');
        text += isComment ? ' ' : c;
    }
    return listedSpectrum(context, at, std::move(text), role);
}

/// The number of "5000K".
double kelvinOf(MitsubaContext* context, const MitsubaElement& at, std::string_view temperature) {
    if (temperature.ends_with('K') || temperature.ends_with('k')) { temperature.remove_suffix(1); }
    return std::clamp(mitsubaNumber(context, at, temperature), 1.0, 1e6);
}

/// "nm value nm value …" of values whose wavelengths lie evenly between two.
std::string evenlySpaced(MitsubaObject* object) {
    const double first = object->number("wavelength_min", object->number("lambda_min", 360.0f));
    const double last = object->number("wavelength_max", object->number("lambda_max", 830.0f));
    const std::vector<std::string_view> values = mitsubaWords(object->text("values"));
    std::string list;
    for (size_t i = 0; i < values.size(); ++i) {
        const double share =
            values.size() < 2 ? 0.0 : static_cast<double>(i) / static_cast<double>(values.size() - 1);
        list += fmt::format("{} {} ", first + share * (last - first), values[i]);
    }
    return list;
}

/// <spectrum type="…"> with properties of its own.
Vec3 pluginSpectrum(MitsubaContext* context, const MitsubaElement& at, SpectrumRole role) {
    MitsubaObject object(context, at);
    const std::string_view type = object.type();
    const float scale = object.number("scale", 1.0f, 0.0f);
    Vec3 color(1.0f);
    if (type == "uniform") {
        color = Vec3(object.number("value", 1.0f));
    } else if (type == "d65" || type == "srgb" || type == "srgb_d65") {
        if (const MitsubaElement* value = object.property("color")) {
            color = mitsubaColor(context, *value, SpectrumRole::Emission);
        }
    } else if (type == "blackbody") {
        const MitsubaElement* kelvin = object.property("temperature");
        if (kelvin != nullptr) {
            color = rgbOfBlackbody(kelvinOf(context, *kelvin, kelvin->attribute("value")));
        }
    } else if (type == "irregular") {
        const std::vector<std::string_view> nm = mitsubaWords(object.text("wavelengths"));
        const std::vector<std::string_view> values = mitsubaWords(object.text("values"));
        std::string list;
        for (size_t i = 0; i < std::min(nm.size(), values.size()); ++i) {
            list += fmt::format("{} {} ", nm[i], values[i]);
        }
        color = listedSpectrum(context, at, std::move(list), role);
    } else if (type == "regular") {
        color = listedSpectrum(context, at, evenlySpaced(&object), role);
    } else {
        context->refuse(at, fmt::format("Glint does not read spectra of type \"{}\"", type));
    }
    object.finish();
    return sane(context, at, scale * color, role);
}

}  // namespace

Vec3 mitsubaColor(MitsubaContext* context, const MitsubaElement& at, SpectrumRole role) {
    const std::string_view value = at.attribute("value");
    if (at.tag == "blackbody") {
        const double scale = at.has("scale") ? mitsubaNumber(context, at, at.attribute("scale")) : 1.0;
        const double kelvin = kelvinOf(context, at, at.attribute("temperature"));
        return sane(context, at, static_cast<float>(scale) * rgbOfBlackbody(kelvin), role);
    }
    if (at.tag == "spectrum" && at.has("type")) { return pluginSpectrum(context, at, role); }
    if (at.tag == "spectrum" && at.has("filename")) { return fileSpectrum(context, at, role); }
    if (at.tag == "spectrum" && value.find(':') != std::string_view::npos) {
        return listedSpectrum(context, at, std::string(value), role);
    }
    const std::vector<std::string_view> words = mitsubaWords(value);
    if (words.size() == 1 && words[0].starts_with('#')) { return hexColor(context, at, words[0].substr(1)); }
    const std::vector<double> v = mitsubaNumbers(context, at, value, {1, 3});
    if (v.empty()) { return {}; }
    Vec3 color = v.size() == 3 ? Vec3(glm::dvec3(v[0], v[1], v[2])) : Vec3(static_cast<float>(v[0]));
    if (at.tag == "srgb") { color = {srgbToLinear(color.x), srgbToLinear(color.y), srgbToLinear(color.z)}; }
    return sane(context, at, color, role);
}

std::optional<MitsubaInput> mitsubaInput(MitsubaObject* object, std::initializer_list<std::string_view> names,
                                         SpectrumRole role) {
    for (const std::string_view name : names) {
        const MitsubaElement* at = object->property(name);
        if (at == nullptr) { continue; }
        if (at->tag == "texture") { return MitsubaInput{Vec3(0.5f), at}; }
        return MitsubaInput{mitsubaColor(&object->context(), *at, role), nullptr};
    }
    return std::nullopt;
}

}  // namespace glint
