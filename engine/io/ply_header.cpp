// One function per header line. The file's format is described in G. Turk's "The PLY Polygon File
// Format" (1994).
#include "engine/io/ply_header.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "engine/io/file_kind.h"
#include "engine/io/image_formats.h"
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

constexpr char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool sameWord(std::string_view a, std::string_view b) { return std::ranges::equal(a, b, {}, lower, lower); }

class HeaderParser {
  public:
    HeaderParser(const std::string& bytes, const std::string& path)
        : begin_(bytes.data()), cursor_(bytes, path) {}

    Result<PlyHeader> run() {
        if (keyword() != "ply") {
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
    /// The next word in small letters, which is how the format writes it.
    std::string keyword() {
        cursor_.atLineEnd();
        const char* where = cursor_.position();
        const std::string_view word = cursor_.word();
        std::string small(word);
        std::ranges::transform(word, small.begin(), lower);
        if (small != word) { cursor_.remark(where, "words of the header in other case", word); }
        return small;
    }

    bool parseLine(bool* ended) {
        cursor_.atLineEnd();
        const char* where = cursor_.position();
        const std::string_view first = cursor_.word();
        for (const std::string_view known :
             {"comment", "obj_info", "format", "element", "property", "end_header"}) {
            if (!sameWord(first, known)) { continue; }
            cursor_.setPosition(where);
            keyword();
            *ended = known == "end_header";
            return known == "format"     ? parseFormat()
                   : known == "element"  ? parseElement(where)
                   : known == "property" ? parseProperty(where)
                                         : *ended || parseComment();
        }
        cursor_.remark(where, "header lines that are no statement of the format are left out", first);
        cursor_.restOfLine();
        return true;
    }

    /// MeshLab and others name images in comments.
    bool parseComment() {
        const char* where = cursor_.position();
        std::string_view word = cursor_.word();
        word = word.substr(0, word.find_last_not_of(':') + 1);
        const std::string_view name = cursor_.restOfLine();
        if (sameWord(word, "TextureFile")) {
            header_.textures.emplace_back(name);
        } else if ((sameWord(word, "texture") || sameWord(word, "texture_file")) &&
                   kindByName(imageFormats(), std::string(name)) != nullptr) {
            cursor_.remark(where, "comments that name an image in other words than TextureFile", name);
            header_.textures.emplace_back(name);
        }
        return true;
    }

    bool parseFormat() {
        cursor_.atLineEnd();
        const char* where = cursor_.position();
        const std::string name = keyword();
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
        property.isList = sameWord(cursor_.word(), "list");
        cursor_.setPosition(at);
        if (property.isList) {
            keyword();
            if (!parseType(&property.countType)) { return false; }
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
        const std::optional<PlyType> found = typeFromName(keyword());
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

size_t sizeOfPlyHeader(const std::string& bytes) {
    constexpr std::string_view kEnd = "end_header";
    const auto found = std::search(bytes.begin(), bytes.end(), kEnd.begin(), kEnd.end(),
                                   [](char a, char b) { return lower(a) == b; });
    size_t end = static_cast<size_t>(found - bytes.begin());
    const bool hasFeeds = bytes.find('\n') < end;
    end = std::min(bytes.find_first_of("\r\n", end), bytes.size());
    return std::min(end + (hasFeeds && bytes[end] == '\r' ? 2 : 1), bytes.size());
}

Result<PlyHeader> parsePlyHeader(const std::string& bytes, const std::string& path) {
    return HeaderParser(bytes, path).run();
}

}  // namespace glint
