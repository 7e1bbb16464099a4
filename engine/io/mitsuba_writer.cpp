#include "engine/io/mitsuba_writer.h"

#include <algorithm>

#include <fmt/format.h>

#include "engine/base/markup.h"

namespace glint {

std::string xmlText(std::string_view text) {
    std::string out;
    for (const char c : escapedMarkup(text)) {
        out += c == '$' ? "\\$" : std::string(1, c);
    }
    return out;
}

std::string xmlNumbers(const Vec3& v) { return fmt::format("{}, {}, {}", v.x, v.y, v.z); }

void MitsubaWriter::open(std::string_view tag, std::string_view attributes) {
    text_ += fmt::format("{:{}}<{} {}>\n", "", 2 * open_.size(), tag, attributes);
    open_.emplace_back(tag);
}

void MitsubaWriter::close() {
    const std::string tag = open_.back();
    open_.pop_back();
    text_ += fmt::format("{:{}}</{}>\n", "", 2 * open_.size(), tag);
}

void MitsubaWriter::element(std::string_view tag, std::string_view attributes) {
    text_ += fmt::format("{:{}}<{} {}/>\n", "", 2 * open_.size(), tag, attributes);
}

void MitsubaWriter::number(std::string_view name, float value) {
    element("float", fmt::format("name=\"{}\" value=\"{}\"", name, value));
}

void MitsubaWriter::integer(std::string_view name, int value) {
    element("integer", fmt::format("name=\"{}\" value=\"{}\"", name, value));
}

void MitsubaWriter::flag(std::string_view name, bool value) {
    element("boolean", fmt::format("name=\"{}\" value=\"{}\"", name, value));
}

void MitsubaWriter::string(std::string_view name, std::string_view value) {
    element("string", fmt::format("name=\"{}\" value=\"{}\"", name, xmlText(value)));
}

void MitsubaWriter::color(std::string_view name, const Vec3& value) {
    element("rgb", fmt::format("name=\"{}\" value=\"{}\"", name, xmlNumbers(value)));
}

void MitsubaWriter::matrix(std::string_view name, const Affine& value) {
    std::string rows;
    for (int row = 0; row < 3; ++row) {
        const Mat3& m = value.linear;
        rows += fmt::format("{} {} {} {} ", m[0][row], m[1][row], m[2][row], value.translation[row]);
    }
    open("transform", fmt::format("name=\"{}\"", name));
    element("matrix", fmt::format("value=\"{}0 0 0 1\"", rows));
    close();
}

std::string MitsubaUse::id(const SceneDescription& scene) const {
    std::string id = fmt::format("m{}{}{}{}_", material, origin == UvOrigin::Top ? "t" : "",
                                 isOneSided ? "f" : "", hasColors ? "c" : "");
    for (const char c : scene.materials[static_cast<size_t>(material)].name) {
        const bool isPlain = (c >= '0' && c <= '9') || ((c | 32) >= 'a' && (c | 32) <= 'z');
        id += isPlain ? c : '_';
    }
    return id;
}

}  // namespace glint
