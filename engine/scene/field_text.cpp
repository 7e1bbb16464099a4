#include "engine/scene/field_text.h"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace glint {
namespace {

template <class Number>
bool parseAll(std::string_view text, Number* out) {
    const char* end = text.data() + text.size();
    const auto [stop, problem] = std::from_chars(text.data(), end, *out);
    return problem == std::errc() && stop == end;
}

}  // namespace

bool parseNumber(std::string_view text, const NumberRange& range, float* out) {
    float number = 0.0f;
    if (!parseAll(text, &number) || !range.contains(static_cast<double>(number))) { return false; }
    *out = number;
    return true;
}

bool parseWhole(std::string_view text, const NumberRange& range, int64_t* out) {
    int64_t number = 0;
    if (!parseAll(text, &number) || !range.contains(static_cast<double>(number))) { return false; }
    *out = number;
    return true;
}

bool parseVector(std::string_view text, const NumberRange& range, int count, float* out) {
    Vec3 vector(0.0f);
    for (int axis = 0; axis < count; ++axis) {
        const size_t comma = std::min(text.find(','), text.size());
        if ((comma < text.size()) != (axis < count - 1) ||
            !parseNumber(text.substr(0, comma), range, &vector[axis])) {
            return false;
        }
        text.remove_prefix(std::min(comma + 1, text.size()));
    }
    std::copy_n(&vector.x, count, out);
    return true;
}

std::string inLowerCase(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) {
        c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    }
    return lower;
}

std::string describeField(const FieldTraits& traits, bool capitalised) {
    const bool both = !traits.help.empty() && !traits.unit.empty();
    std::string text = fmt::format("{}{}{}", traits.help, both ? " " : "",
                                   traits.unit.empty() ? "" : fmt::format("({})", traits.unit));
    if (capitalised && !text.empty()) {
        text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    }
    return text;
}

}  // namespace glint
