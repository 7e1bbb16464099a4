// Vertices and faces of OBJ files.
#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "engine/io/obj_parser.h"

namespace glint {
namespace {

/// Larger coordinates have squared lengths that overflow float.
constexpr float kMaxCoordinate = 1e18f;
constexpr size_t kMaxPoolEntries = INT32_MAX;

constexpr const char* kNames[] = {"vertex", "texture coordinate", "normal"};

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\\' || c == '\0'; }

}  // namespace

bool ObjParser::countLine(Attribute attribute) {
    defined_[attribute] = ++known_[attribute];
    return known_[attribute] < kMaxPoolEntries ||
           cursor_.fail(cursor_.position(), "the file has more than 2^31 such lines");
}

void ObjParser::leaveOutRest(const char* where) {
    if (!cursor_.atLineEnd()) {
        cursor_.remark(where, "more on a line than it can have is left out", cursor_.word());
    }
}

bool ObjParser::parsePosition() {
    const char* where = cursor_.position();
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) {
        static constexpr const char* kAxes[] = {"x", "y", "z"};
        cursor_.atLineEnd();
        const char* numberPlace = cursor_.position();
        if (!cursor_.readFloat(kAxes[axis], &p[axis])) { return false; }
        if (std::fabs(p[axis]) > kMaxCoordinate) {
            return cursor_.fail(numberPlace, "this coordinate is too large; expected at most 1e18");
        }
    }
    std::vector<Vec3>& colors = pools_.colors;
    if (!cursor_.atLineEnd()) {
        float more[4] = {};
        const int count = cursor_.readSomeFloats(4, more);
        if (count >= 3) {
            colors.resize(pools_.positions.size(), Vec3(1.0f));
            colors.emplace_back(more[0], more[1], more[2]);
        }
        if (count == 2) { cursor_.remark(where, "the numbers behind x y z are neither w nor a colour"); }
        if (count == 4) { cursor_.remark(where, "vertex colours have an alpha, which is left out"); }
        leaveOutRest(where);
    }
    if (!colors.empty()) { colors.resize(pools_.positions.size() + 1, Vec3(1.0f)); }
    pools_.positions.push_back(p);
    return countLine(kPosition);
}

/// ZBrush's vertex colours: comments of 8 hexadecimal digits for each vertex, a mask and sRGB bytes.
void ObjParser::readPolypaint() {
    constexpr std::string_view kMark = "#MRGB ";
    const char* at = cursor_.position();
    if (!std::string_view(at, static_cast<size_t>(cursor_.end() - at)).starts_with(kMark)) { return; }
    at += kMark.size();
    pools_.colors.resize(pools_.positions.size(), Vec3(1.0f));
    for (; cursor_.end() - at >= 8 && painted_ < pools_.colors.size(); at += 8, ++painted_) {
        uint32_t mrgb = 0;
        if (std::from_chars(at, at + 8, mrgb, 16).ptr != at + 8) { return; }
        const auto channel = [mrgb](int shift) { return static_cast<float>(mrgb >> shift & 255) / 255.0f; };
        pools_.colors[painted_] = {channel(16), channel(8), channel(0)};
    }
}

bool ObjParser::parseUv() {
    const char* where = cursor_.position();
    float uvw[3] = {};
    if (cursor_.readSomeFloats(3, uvw) == 0) {
        cursor_.remark(where, "texture coordinates without numbers count as 0 0");
    }
    leaveOutRest(where);
    pools_.uvs.emplace_back(uvw[0], uvw[1]);
    return countLine(kUv);
}

bool ObjParser::parseNormal() {
    const char* where = cursor_.position();
    Vec3 n(0.0f);
    if (cursor_.readSomeFloats(3, &n[0]) < 3) { n = Vec3(0.0f); }
    leaveOutRest(where);
    const float largest = maxComponent(absVec(n));
    if (largest == 0.0f) { cursor_.remark(where, "normals without a direction count as missing"); }
    // A length that float cannot square is no reason to lose the direction.
    const bool isExtreme = largest > kMaxCoordinate || (largest > 0.0f && largest < 1e-18f);
    pools_.normals.push_back(isExtreme ? n / largest : n);
    return countLine(kNormal);
}

bool ObjParser::parseFace(const char* where) {
    corners_.clear();
    while (!cursor_.atLineEnd()) {
        if (!parseCorner(&corners_.emplace_back())) { return false; }
    }
    if (corners_.size() < 3) {
        cursor_.remark(where, "faces of fewer than 3 corners are left out");
        return true;
    }
    if (builder_.empty()) { partName_ = name_; }
    if (smoothing_.empty() || smoothing_.back().group != group_) {
        smoothing_.push_back({builder_.triangleCount(), group_});
    }
    if (!builder_.addFace(corners_)) {
        cursor_.remark(where, "faces of thousands of corners that are not convex are left out");
    }
    return true;
}

bool ObjParser::parseCorner(ObjCorner* corner) {
    const char* at = cursor_.position();
    if (!parseIndex(&at, kPosition, &corner->position)) { return false; }
    if (*at == '/' && !parseOptionalIndex(&at, kUv, &corner->uv)) { return false; }
    if (*at == '/' && !parseOptionalIndex(&at, kNormal, &corner->normal)) { return false; }
    const char* wordEnd = cursor_.position() + cursor_.word().size();
    return at == wordEnd || cursor_.fail(at, "expected a corner like 1, 1/2, 1//3 or 1/2/3");
}

bool ObjParser::parseOptionalIndex(const char** at, Attribute attribute, int32_t* index) {
    const char* slash = (*at)++;
    if (attribute == kUv && **at == '/') { return true; }
    if (isBlank(**at)) {
        cursor_.remark(slash, "no index behind a slash: as if the slash were missing");
        return true;
    }
    return parseIndex(at, attribute, index);
}

/// Reads an index at `*at`, counting from 1, or from the last one backwards when negative, and moves `*at`
/// behind it.
bool ObjParser::parseIndex(const char** at, Attribute attribute, int32_t* index) {
    int64_t number = 0;
    const char* first = *at;
    auto [last, code] = std::from_chars(first, cursor_.end(), number);
    if (code == std::errc() && number > 0 && static_cast<size_t>(number) <= known_[attribute] &&
        *last != '.') {
        *index = static_cast<int32_t>(number - 1);
        *at = last;
        return true;
    }
    if (code == std::errc::invalid_argument) {
        return cursor_.fail(first, fmt::format("expected the number of a {}", kNames[attribute]));
    }
    if (code != std::errc()) { number = INT64_MAX; }
    const std::string_view word(first, static_cast<size_t>(last - first));
    if (*last == '.' && last[1] == '0') {
        cursor_.remark(first, "a whole number is written with a point");
        last = std::find_if(last + 1, cursor_.end(), [](char c) { return c != '0'; });
    }
    *at = last;
    return resolveIndex(number, word, attribute, index);
}

bool ObjParser::resolveIndex(int64_t number, std::string_view word, Attribute attribute, int32_t* index) {
    const int64_t known = static_cast<int64_t>(known_[attribute]);
    const int64_t resolved = number > 0 ? number - 1 : static_cast<int64_t>(defined_[attribute]) + number;
    if (number != 0 && resolved >= 0 && resolved < known) {
        *index = static_cast<int32_t>(resolved);
        return true;
    }
    if (number > 0 && !verticesFirst_) {
        needsVerticesFirst_ = true;
        return false;
    }
    if (attribute != kPosition) {
        cursor_.remark(word.data(),
                       attribute == kUv ? "texture coordinates that faces name are not there"
                                        : "normals that faces name are not there",
                       word);
        return true;
    }
    return cursor_.fail(
        word.data(), number == 0 ? "the vertex has number 0; they count from 1"
                                 : fmt::format("there is no vertex {}; {} are defined{}", word,
                                               number > 0 ? known : static_cast<int64_t>(defined_[kPosition]),
                                               number > 0 ? "" : " up to here"));
}

}  // namespace glint
