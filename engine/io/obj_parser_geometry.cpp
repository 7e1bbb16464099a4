// Vertices and faces of OBJ files.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "engine/io/obj_parser.h"

namespace glint {
namespace {

constexpr size_t kMaxPoolEntries = INT32_MAX;

constexpr std::string_view kMoreOnALine = "more on a line than it can have is left out";
constexpr const char* kNames[] = {"vertex", "texture coordinate", "normal"};

/// Whole numbers that are written in another way: +1, 1., 1e0. Null: it is none; else where it ends.
const char* parseWholeNumber(const char* first, const char* end, int64_t* number) {
    double value = 0.0;
    const auto [last, code] = std::from_chars(*first == '+' ? first + 1 : first, end, value);
    if (code != std::errc() || value != std::floor(value)) { return nullptr; }  // NaN is none, too
    constexpr double kMost = 9e18;
    *number = static_cast<int64_t>(std::clamp(value, -kMost, kMost));
    return last;
}

}  // namespace

bool ObjParser::countLine(Attribute attribute) {
    defined_[attribute] = ++known_[attribute];
    return known_[attribute] < kMaxPoolEntries ||
           cursor_.fail(cursor_.position(), "the file has more than 2^31 such lines");
}

void ObjParser::leaveOutRest(const char* where) {
    if (!cursor_.atLineEnd()) { cursor_.remark(where, kMoreOnALine, cursor_.word()); }
}

bool ObjParser::readPosition(Vec3* p) {
    for (int axis = 0; axis < 3; ++axis) {
        static constexpr const char* kAxes[] = {"x", "y", "z"};
        cursor_.atLineEnd();
        const char* numberPlace = cursor_.position();
        if (!cursor_.readFloat(kAxes[axis], &(*p)[axis])) { return false; }
        if (std::fabs((*p)[axis]) > kMaxCoordinate) {
            return cursor_.fail(numberPlace, "this coordinate is too large; expected at most 1e18");
        }
    }
    return true;
}

/// What a face makes of a vertex that has no position: the error of its line.
bool ObjParser::failAtVertex(int32_t index) {
    const auto line = std::ranges::lower_bound(unplaced_, static_cast<size_t>(index), {},
                                               &std::pair<size_t, const char*>::first);
    if (line == unplaced_.end() || line->first != static_cast<size_t>(index)) { return true; }
    const char* behind = cursor_.position();
    cursor_.setPosition(line->second);
    Vec3 ignored;
    const bool isRead = readPosition(&ignored);
    cursor_.setPosition(behind);
    return isRead;
}

bool ObjParser::parsePosition() {
    const char* where = cursor_.position();
    Vec3 p(0.0f);
    if (!readPosition(&p)) {
        cursor_.remark(where, "vertices without a finite position, which no face uses, are left out");
        unplaced_.emplace_back(pools_.positions.size(), where);
        cursor_.restOfLine();
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
        if (parseCorner(&corners_.emplace_back())) { continue; }
        if (needsVerticesFirst_) { return false; }
        corners_.pop_back();
        return recoverFace(where);
    }
    return addFace(where);
}

void ObjParser::keepFirstOddFace(const Error& error) {
    if (!firstOddFace_) { firstOddFace_ = error; }
}

/// Goes on behind a corner that cannot be read; corners_ are those before it.
bool ObjParser::recoverFace(const char* where) {
    const bool isNumber = std::exchange(failedAtNumber_, false);
    size_t behind = 0;
    while (!cursor_.word().empty()) {
        ++behind;
    }
    if (isNumber && corners_.size() + 1 + behind >= 3) { return false; }
    if (!isNumber && corners_.size() >= 3 && behind == 0) {
        cursor_.remark(where, kMoreOnALine);
        return addFace(where);
    }
    if (!isNumber) {
        cursor_.remark(where, "faces with corners that are no numbers are left out");
        keepFirstOddFace(cursor_.error());
        return true;
    }
    corners_.clear();
    return addFace(where);
}

bool ObjParser::addFace(const char* where) {
    if (corners_.size() < 3) {
        cursor_.remark(where, "faces of fewer than 3 corners are left out");
        return true;
    }
    if (builder_.empty()) { partName_ = name_; }
    if (smoothing_.empty() || smoothing_.back().group != group_) {
        smoothing_.push_back({builder_.triangleCount(), group_});
    }
    if (!builder_.addFace(corners_)) {
        constexpr std::string_view kLeftOut =
            "faces of thousands of corners that are not convex are left out";
        cursor_.remark(where, kLeftOut);
        keepFirstOddFace({std::string(kLeftOut), cursor_.placeOf(where)});
    }
    return true;
}

bool ObjParser::parseCorner(ObjCorner* corner) {
    const std::string_view word = cursor_.word();
    const char* at = word.data();
    const char* const end = at + word.size();
    if (!parseIndex(&at, end, kPosition, &corner->position)) { return false; }
    if (at != end && *at == '/' && !parseOptionalIndex(&at, end, kUv, &corner->uv)) { return false; }
    if (at != end && *at == '/' && !parseOptionalIndex(&at, end, kNormal, &corner->normal)) { return false; }
    if (at == end) { return true; }
    if (*at == '/') {
        cursor_.remark(at, "what stands behind a corner's third slash is left out");
        return true;
    }
    if (*at == '#') {
        cursor_.setPosition(at);
        return true;
    }
    return cursor_.fail(at, "expected a corner like 1, 1/2, 1//3 or 1/2/3");
}

bool ObjParser::parseOptionalIndex(const char** at, const char* end, Attribute attribute, int32_t* index) {
    const char* slash = (*at)++;
    if (*at == end) {
        cursor_.remark(slash, "no index behind a slash: as if the slash were missing");
        return true;
    }
    return **at == '/' || parseIndex(at, end, attribute, index);
}

/// Reads an index at `*at`, counting from 1, or from the last one backwards when negative, and moves `*at`
/// behind it.
bool ObjParser::parseIndex(const char** at, const char* end, Attribute attribute, int32_t* index) {
    int64_t number = 0;
    const char* first = *at;
    auto [last, code] = std::from_chars(first, end, number);
    const bool isPlain = code == std::errc() && *last != '.' && *last != 'e' && *last != 'E';
    if (isPlain && number > 0 && static_cast<size_t>(number) <= known_[attribute] && unplaced_.empty()) {
        *index = static_cast<int32_t>(number - 1);
        *at = last;
        return true;
    }
    if (!isPlain) {
        last = parseWholeNumber(first, end, &number);
        if (last == nullptr) { return leaveOutIndex(at, end, attribute); }
        if (code != std::errc::result_out_of_range) {
            cursor_.remark(first, "a whole number is written with a point or a sign");
        }
    }
    *at = last;
    return resolveIndex(number, {first, static_cast<size_t>(last - first)}, attribute, index);
}

/// Of what is no number: a corner without a texture coordinate or normal, and none without a vertex.
bool ObjParser::leaveOutIndex(const char** at, const char* end, Attribute attribute) {
    if (attribute == kPosition) {
        return cursor_.fail(*at, fmt::format("expected the number of a {}", kNames[attribute]));
    }
    cursor_.remark(*at, "texture coordinates and normals of corners that are no numbers count as missing");
    *at = std::find(*at, end, '/');
    return true;
}

bool ObjParser::resolveIndex(int64_t number, std::string_view word, Attribute attribute, int32_t* index) {
    const int64_t known = static_cast<int64_t>(known_[attribute]);
    const int64_t resolved = number > 0 ? number - 1 : static_cast<int64_t>(defined_[attribute]) + number;
    if (number != 0 && resolved >= 0 && resolved < known) {
        *index = static_cast<int32_t>(resolved);
        failedAtNumber_ = attribute == kPosition && !failAtVertex(*index);
        return !failedAtNumber_;
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
    failedAtNumber_ = true;
    return cursor_.fail(
        word.data(), number == 0 ? "the vertex has number 0; they count from 1"
                                 : fmt::format("there is no vertex {}; {} are defined{}", word,
                                               number > 0 ? known : static_cast<int64_t>(defined_[kPosition]),
                                               number > 0 ? "" : " up to here"));
}

}  // namespace glint
