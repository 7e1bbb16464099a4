// One function per header line. The file's format is described in G. Turk's "The PLY Polygon File
// Format" (1994).
#include "engine/io/ply_header.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "engine/io/text_cursor.h"

namespace glint {
namespace {

constexpr int64_t kMaxElements = int64_t{1} << 40;

std::optional<PlyType> typeFromName(std::string_view name) {
    static constexpr std::pair<std::string_view, PlyType> kNames[] = {
        {"char", PlyType::Int8},      {"int8", PlyType::Int8},       {"uchar", PlyType::Uint8},
        {"uint8", PlyType::Uint8},    {"short", PlyType::Int16},     {"int16", PlyType::Int16},
        {"ushort", PlyType::Uint16},  {"uint16", PlyType::Uint16},   {"int", PlyType::Int32},
        {"int32", PlyType::Int32},    {"uint", PlyType::Uint32},     {"uint32", PlyType::Uint32},
        {"float", PlyType::Float32},  {"float32", PlyType::Float32}, {"double", PlyType::Float64},
        {"float64", PlyType::Float64}};
    for (const auto& [known, type] : kNames) {
        if (known == name) { return type; }
    }
    return std::nullopt;
}

bool sameWord(std::string_view a, std::string_view b) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c; };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [&](char x, char y) { return lower(x) == lower(y); });
}

class HeaderParser {
  public:
    HeaderParser(const std::string& bytes, const std::string& path)
        : begin_(bytes.data()), cursor_(bytes, path) {}

    Result<PlyHeader> run() {
        if (cursor_.word() != "ply") {
            cursor_.fail(begin_, "expected the word ply in the first line; is this a PLY file?");
            return cursor_.error();
        }
        bool ended = false;
        for (cursor_.nextLine(); !ended && !cursor_.atEnd(); cursor_.nextLine()) {
            if (!cursor_.atLineEnd() && !parseLine(&ended)) { return cursor_.error(); }
        }
        if (!ended || !hasFormat_) {
            cursor_.fail(cursor_.position(), ended ? "expected a format line in the header"
                                                   : "the header does not end; expected the line end_header");
            return cursor_.error();
        }
        header_.bodyOffset = static_cast<size_t>(cursor_.position() - begin_);
        header_.warnings = cursor_.remarks().lines();
        return std::move(header_);
    }

  private:
    bool parseLine(bool* ended) {
        const char* where = cursor_.position();
        const std::string_view keyword = cursor_.word();
        if (keyword == "comment" || keyword == "obj_info") {
            parseComment();
            return true;
        }
        if (keyword == "format") { return parseFormat(); }
        if (keyword == "element") { return parseElement(where); }
        if (keyword == "property") { return parseProperty(where); }
        *ended = keyword == "end_header";
        if (!*ended) {
            cursor_.remark(where, "header lines that are no statement of the format are left out", keyword);
            cursor_.restOfLine();
        }
        return true;
    }

    /// MeshLab and others name images in comments.
    void parseComment() {
        const char* at = cursor_.position();
        if (sameWord(cursor_.word(), "TextureFile")) {
            header_.textures.emplace_back(cursor_.restOfLine());
        } else {
            cursor_.setPosition(at);
            cursor_.restOfLine();
        }
    }

    bool parseFormat() {
        cursor_.atLineEnd();
        const char* where = cursor_.position();
        const std::string_view name = cursor_.word();
        if (name == "ascii") {
            header_.format = PlyFormat::Ascii;
        } else if (name == "binary_little_endian") {
            header_.format = PlyFormat::BinaryLittleEndian;
        } else if (name == "binary_big_endian") {
            header_.format = PlyFormat::BinaryBigEndian;
        } else {
            return cursor_.fail(where, "expected ascii, binary_little_endian or binary_big_endian");
        }
        hasFormat_ = true;
        cursor_.atLineEnd();
        const char* versionPlace = cursor_.position();
        if (cursor_.word() != "1.0") {
            cursor_.remark(versionPlace, "the version is not 1.0; read as if it were");
        }
        return true;
    }

    bool parseElement(const char* where) {
        PlyElement element;
        element.name = cursor_.word();
        cursor_.atLineEnd();
        const char* countPlace = cursor_.position();
        int64_t count = 0;
        if (element.name.empty() || !cursor_.readInt("the number of elements", &count)) {
            return element.name.empty() ? cursor_.fail(where, "expected a name and a number after element")
                                        : false;
        }
        if (count < 0 || count > kMaxElements) {
            return cursor_.fail(countPlace, fmt::format("there cannot be {} elements", count));
        }
        element.count = static_cast<uint64_t>(count);
        element.place = cursor_.placeOf(countPlace);
        header_.elements.push_back(std::move(element));
        return cursor_.expectLineEnd("the number of elements");
    }

    bool parseProperty(const char* where) {
        if (header_.elements.empty()) {
            return cursor_.fail(where, "expected an element line before its properties");
        }
        PlyProperty property;
        cursor_.atLineEnd();
        const char* at = cursor_.position();
        property.isList = cursor_.word() == "list";
        if (!property.isList) {
            cursor_.setPosition(at);
        } else if (!parseType(&property.countType)) {
            return false;
        }
        if (!parseType(&property.type)) { return false; }
        property.name = cursor_.word();
        if (property.name.empty()) {
            return cursor_.fail(where, "expected a type and a name after property");
        }
        header_.elements.back().properties.push_back(std::move(property));
        return cursor_.expectLineEnd("the property's name");
    }

    bool parseType(PlyType* type) {
        cursor_.atLineEnd();
        const char* where = cursor_.position();
        const std::optional<PlyType> found = typeFromName(cursor_.word());
        *type = found.value_or(PlyType::Float32);
        return found ||
               cursor_.fail(where, "expected a type: char, uchar, short, ushort, int, uint, float or double");
    }

    const char* begin_;
    TextCursor cursor_;
    PlyHeader header_;
    bool hasFormat_ = false;
};

}  // namespace

bool PlyElement::is(std::initializer_list<std::string_view> names) const {
    return std::any_of(names.begin(), names.end(),
                       [&](std::string_view candidate) { return sameWord(name, candidate); });
}

int PlyElement::find(std::initializer_list<std::string_view> names) const {
    for (size_t i = 0; i < properties.size(); ++i) {
        for (const std::string_view candidate : names) {
            if (sameWord(properties[i].name, candidate)) { return static_cast<int>(i); }
        }
    }
    return -1;
}

Result<PlyHeader> parsePlyHeader(const std::string& bytes, const std::string& path) {
    return HeaderParser(bytes, path).run();
}

}  // namespace glint
