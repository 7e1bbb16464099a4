#include "engine/io/obj_parser.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

namespace glint {
namespace {

/// Statements of the format that are left out. The first row changes nothing in a mesh; the second row is
/// drawn by others, so leaving it out is reported.
constexpr std::string_view kSilent[] = {"mg", "lod",    "bevel",  "c_interp",  "d_interp", "shadow_obj",
                                        "vp", "usemap", "maplib", "trace_obj", "ctech",    "stech"};
constexpr std::string_view kReported[] = {"p",    "l",    "curv", "curv2", "surf", "cstype", "deg", "bmat",
                                          "step", "parm", "trim", "hole",  "scrv", "sp",     "end", "con",
                                          "call", "csh",  "bzp",  "bsp",   "cdc",  "cdp",    "res"};
constexpr std::string_view kRead[] = {"v", "vt", "vn", "f", "fo", "g", "o", "s", "usemtl", "mtllib"};

template <size_t kCount>
bool isOneOf(std::string_view word, const std::string_view (&words)[kCount]) {
    return std::find(std::begin(words), std::end(words), word) != std::end(words);
}

std::string lowerCase(std::string_view word) {
    std::string lower(word);
    for (char& c : lower) {
        c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    }
    return lower;
}

bool isText(std::string_view word) {
    return std::none_of(word.begin(), word.end(),
                        [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; });
}

}  // namespace

Status ObjParser::run() {
    const char* begin = cursor_.position();
    if (verticesFirst_) {
        if (!runLines(&ObjParser::parseAttribute)) { return cursor_.error(); }
        cursor_.setPosition(begin);
        defined_ = {};
    }
    if (!runLines(&ObjParser::parseStatement)) {
        return needsVerticesFirst_ ? Error{"a face names what comes later", {}} : cursor_.error();
    }
    finishPart();
    return file.parts.empty() ? Status(noFaces()) : Status();
}

bool ObjParser::runLines(bool (ObjParser::*parse)(std::string_view, const char*)) {
    for (; !cursor_.atEnd(); cursor_.nextLine()) {
        if (cursor_.atLineEnd()) {
            if (parse == &ObjParser::parseAttribute || !verticesFirst_) { readPolypaint(); }
            continue;
        }
        const char* where = cursor_.position();
        if (!(this->*parse)(cursor_.word(), where)) { return false; }
    }
    return true;
}

Error ObjParser::noFaces() {
    if (firstOddFace_) { return *firstOddFace_; }
    if (!unplaced_.empty() && !failAtVertex(static_cast<int32_t>(unplaced_[0].first))) {
        return cursor_.error();
    }
    if (firstOdd_ != nullptr && pools_.positions.empty()) {
        return {"expected an OBJ statement (v, vt, vn, f, g, o, usemtl, mtllib, …); is this an OBJ file?",
                cursor_.placeOf(firstOdd_)};
    }
    const SourcePlace end = cursor_.placeOf(cursor_.end());
    const char* what = pools_.positions.empty() ? "" : ": a point cloud, or lines";
    return {
        fmt::format("the file has no faces ({} vertices){}; expected a mesh", pools_.positions.size(), what),
        {.file = end.file, .line = end.line}};
}

/// v, vt and vn, in any case; everything else waits for the second of two passes.
bool ObjParser::parseAttribute(std::string_view keyword, const char*) {
    constexpr char kSmall = 0x20;
    if (keyword.size() > 2 || (keyword[0] | kSmall) != 'v') { return true; }
    if (keyword.size() == 1) { return parsePosition(); }
    const char kind = static_cast<char>(keyword[1] | kSmall);
    return kind == 't' ? parseUv() : kind != 'n' || parseNormal();
}

bool ObjParser::parseStatement(std::string_view keyword, const char* where) {
    if (keyword.size() <= 2 && keyword[0] == 'v') {
        const size_t attribute = keyword == "v" ? kPosition : keyword == "vt" ? kUv : kNormal;
        const bool known = attribute != kNormal || keyword == "vn";
        if (known && verticesFirst_) {
            ++defined_[attribute];
            return true;
        }
        if (known) { return parseAttribute(keyword, where); }
    }
    if (keyword == "f" || keyword == "fo") { return parseFace(where); }
    if (keyword == "usemtl") {
        useMaterial(where);
    } else if (keyword == "mtllib") {
        file.libraries.emplace_back(cursor_.restOfLine());
        if (file.libraries.back().empty()) {
            cursor_.remark(where, "mtllib without a file name");
            file.libraries.pop_back();
        }
    } else if (keyword == "g" || keyword == "o") {
        name_ = cursor_.restOfLine();
    } else if (keyword == "s") {
        useSmoothing();
    } else {
        return isOneOf(keyword, kSilent) || parseUnknown(keyword, where);
    }
    return true;
}

bool ObjParser::parseUnknown(std::string_view keyword, const char* where) {
    if (const std::string lower = lowerCase(keyword); lower != keyword && isOneOf(lower, kRead)) {
        cursor_.remark(where, "a keyword in capitals counts as in small letters", keyword);
        return parseStatement(lower, where);
    }
    if (isOneOf(keyword, kReported)) {
        cursor_.remark(where, "statements that Glint does not draw are left out", keyword);
        return true;
    }
    if (!isText(keyword)) {
        return cursor_.fail(
            firstOdd_ == nullptr ? where : firstOdd_,
            "expected an OBJ statement (v, vt, vn, f, g, o, usemtl, mtllib, …); is this an OBJ file?");
    }
    firstOdd_ = firstOdd_ == nullptr ? where : firstOdd_;
    cursor_.remark(where, "lines that are no statement of the OBJ format are left out", keyword);
    cursor_.restOfLine();  // a path that ends in a backslash must not take the next line with it
    return true;
}

void ObjParser::useMaterial(const char* where) {
    std::string name(cursor_.restOfLine());
    if (name == materialName_) { return; }
    finishPart();
    materialName_ = std::move(name);
    materialLine_ = cursor_.lineOf(where);
}

/// `s off` and `s 0` end smoothing; a word that is no number is a group of its own name.
void ObjParser::useSmoothing() {
    const std::string_view word = cursor_.word();
    if (word.empty() || word == "off" || word == "0") {
        group_ = Smoothing::Off;
        return;
    }
    int number = 0;
    const auto [last, code] = std::from_chars(word.data(), word.data() + word.size(), number);
    group_ = static_cast<Smoothing>(code == std::errc() && number > 0 ? number : 1);
}

void ObjParser::finishPart() {
    if (builder_.empty()) { return; }
    const std::string& named = !partName_.empty() ? partName_ : materialName_;
    file.parts.push_back({.name = !named.empty() ? named : fmt::format("part {}", file.parts.size()),
                          .materialName = materialName_,
                          .materialLine = materialLine_,
                          .mesh = builder_.finish(),
                          .smoothing = std::move(smoothing_)});
    smoothing_ = {};
}

}  // namespace glint
