// One pass over the text. Materials are looked up at the end, so that `usemtl` may come before its `mtllib`.
#include "engine/io/obj_loader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "engine/io/atomic_file.h"
#include "engine/io/obj_materials.h"
#include "engine/io/obj_part_builder.h"
#include "engine/io/text_cursor.h"

namespace glint {
namespace {

/// Larger coordinates have squared lengths that overflow float.
constexpr float kMaxCoordinate = 1e18f;
constexpr size_t kMaxPoolEntries = INT32_MAX;

/// Statements of the format that are left out. The first row changes nothing in a mesh; the second row is
/// drawn by others, so leaving it out is reported.
constexpr std::string_view kSilent[] = {"s",         "mg",         "lod",  "bevel",  "c_interp",
                                        "d_interp",  "shadow_obj", "vp",   "usemap", "maplib",
                                        "trace_obj", "ctech",      "stech"};
constexpr std::string_view kReported[] = {"p",    "l",    "curv", "curv2", "surf", "cstype", "deg", "bmat",
                                          "step", "parm", "trim", "hole",  "scrv", "sp",     "end", "con",
                                          "call", "csh",  "bzp",  "bsp",   "cdc",  "cdp",    "res"};

template <size_t kCount>
bool isOneOf(std::string_view word, const std::string_view (&words)[kCount]) {
    return std::find(std::begin(words), std::end(words), word) != std::end(words);
}

class ObjParser {
  public:
    ObjParser(const std::string& text, const std::string& path) : cursor_(text, path), builder_(pools_) {}

    Status run();

    MeshFile file;  ///< all but materials and textures

  private:
    bool parseLine();
    bool parseVertex();
    bool parseUv();
    bool parseNormal();
    bool parseFace();
    bool parseCorner(ObjCorner* corner);
    bool parseIndex(const char** at, size_t poolSize, const char* what, int32_t* index);
    bool parseUnknown(std::string_view keyword, const char* where);
    bool checkRoom(size_t poolSize);
    void useMaterial(const char* where);
    void finishPart();

    TextCursor cursor_;
    ObjPools pools_;
    ObjPartBuilder builder_;
    std::vector<ObjCorner> corners_;
    std::string group_;         ///< in force now
    std::string partGroup_;     ///< at the part's first face
    std::string materialName_;  ///< in force now
    std::string materialPlace_;
    std::set<std::string, std::less<>> reported_;
};

Status ObjParser::run() {
    for (; !cursor_.atEnd(); cursor_.nextLine()) {
        if (!cursor_.atLineEnd() && !parseLine()) { return cursor_.error(); }
    }
    finishPart();
    if (file.parts.empty()) {
        const char* last = cursor_.end();
        const SourcePlace place = cursor_.placeOf(last);
        return Error{
            fmt::format("the file has no faces ({} vertices); expected a mesh", pools_.positions.size()),
            {.file = place.file, .line = place.line}};
    }
    return {};
}

bool ObjParser::parseLine() {
    const char* where = cursor_.position();
    const std::string_view keyword = cursor_.word();
    if (keyword == "v") { return parseVertex(); }
    if (keyword == "f" || keyword == "fo") { return parseFace(); }
    if (keyword == "vn") { return parseNormal(); }
    if (keyword == "vt") { return parseUv(); }
    if (keyword == "usemtl") {
        useMaterial(where);
        return true;
    }
    if (keyword == "mtllib") {
        file.libraries.emplace_back(cursor_.restOfLine());
        return !file.libraries.back().empty() ||
               cursor_.fail(cursor_.position(), "expected a file name after mtllib");
    }
    if (keyword == "g" || keyword == "o") {
        group_ = cursor_.restOfLine();
        return true;
    }
    return isOneOf(keyword, kSilent) || parseUnknown(keyword, where);
}

bool ObjParser::parseUnknown(std::string_view keyword, const char* where) {
    const bool isPlainWord = std::all_of(keyword.begin(), keyword.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    });
    if (!isPlainWord || keyword.size() > 32) {
        return cursor_.fail(
            where, "expected an OBJ statement (v, vt, vn, f, g, o, usemtl, mtllib, …); is this an OBJ file?");
    }
    if (reported_.emplace(keyword).second) {
        const char* why =
            isOneOf(keyword, kReported) ? "is not supported" : "is not a statement of the OBJ format";
        file.warnings.push_back(
            cursor_.warning(where, fmt::format("\"{}\" {}; such lines are left out", keyword, why)));
    }
    return true;
}

bool ObjParser::checkRoom(size_t poolSize) {
    return poolSize < kMaxPoolEntries ||
           cursor_.fail(cursor_.position(), "the file has more than 2^31 such lines");
}

bool ObjParser::parseVertex() {
    static constexpr const char* kNames[7] = {
        "x", "y", "z", "the 4th number", "the 5th number", "the 6th number", "the line's end"};
    const char* where = cursor_.position();
    float numbers[7];
    int count = 0;
    while (count < 7 && (count < 3 || !cursor_.atLineEnd())) {
        cursor_.atLineEnd();
        const char* numberPlace = cursor_.position();
        if (!cursor_.readFloat(kNames[count], &numbers[count])) { return false; }
        if (count < 3 && std::fabs(numbers[count]) > kMaxCoordinate) {
            return cursor_.fail(numberPlace, "this coordinate is too large; expected at most 1e18");
        }
        ++count;
    }
    if (count == 5 || count == 7) {
        return cursor_.fail(where, "expected x y z, x y z w or x y z red green blue after v");
    }
    std::vector<Vec3>& colors = pools_.colors;
    if (count == 6) {
        colors.resize(pools_.positions.size(), Vec3(1.0f));
        colors.emplace_back(std::fmax(numbers[3], 0.0f), std::fmax(numbers[4], 0.0f),
                            std::fmax(numbers[5], 0.0f));
    } else if (!colors.empty()) {
        colors.emplace_back(1.0f);
    }
    pools_.positions.emplace_back(numbers[0], numbers[1], numbers[2]);
    return checkRoom(pools_.positions.size());
}

bool ObjParser::parseUv() {
    Vec2 uv(0.0f);
    float unused = 0.0f;
    if (!cursor_.readFloat("u", &uv.x) || (!cursor_.atLineEnd() && !cursor_.readFloat("v", &uv.y)) ||
        (!cursor_.atLineEnd() && !cursor_.readFloat("w", &unused)) || !cursor_.expectLineEnd("u v w")) {
        return false;
    }
    pools_.uvs.push_back(uv);
    return checkRoom(pools_.uvs.size());
}

bool ObjParser::parseNormal() {
    Vec3 n;
    if (!cursor_.readFloat("x", &n.x) || !cursor_.readFloat("y", &n.y) || !cursor_.readFloat("z", &n.z) ||
        !cursor_.expectLineEnd("x y z")) {
        return false;
    }
    // A length that float cannot square is no reason to lose the direction.
    const float largest = maxComponent(absVec(n));
    pools_.normals.push_back(largest > kMaxCoordinate || (largest > 0.0f && largest < 1e-18f) ? n / largest
                                                                                              : n);
    return checkRoom(pools_.normals.size());
}

bool ObjParser::parseFace() {
    const char* where = cursor_.position();
    corners_.clear();
    while (!cursor_.atLineEnd()) {
        if (!parseCorner(&corners_.emplace_back())) { return false; }
    }
    if (corners_.size() < 3) {
        return cursor_.fail(where,
                            fmt::format("the face has {} corners; expected at least 3", corners_.size()));
    }
    if (builder_.empty()) { partGroup_ = group_; }
    return builder_.addFace(corners_) ||
           cursor_.fail(where, fmt::format("the polygon has {} corners, too many of them not convex",
                                           corners_.size()));
}

bool ObjParser::parseCorner(ObjCorner* corner) {
    const char* at = cursor_.position();
    if (!parseIndex(&at, pools_.positions.size(), "vertex", &corner->position)) { return false; }
    if (*at == '/') {
        ++at;
        if (*at != '/' && !parseIndex(&at, pools_.uvs.size(), "texture coordinate", &corner->uv)) {
            return false;
        }
        if (*at == '/') {
            ++at;
            if (!parseIndex(&at, pools_.normals.size(), "normal", &corner->normal)) { return false; }
        }
    }
    const char* wordEnd = cursor_.position() + cursor_.word().size();
    return at == wordEnd || cursor_.fail(at, "expected a corner like 1, 1/2, 1//3 or 1/2/3");
}

/// Reads an index at `*at`, counting from 1, or from the last one backwards when negative, and moves `*at`
/// behind it.
bool ObjParser::parseIndex(const char** at, size_t poolSize, const char* what, int32_t* index) {
    int64_t number = 0;
    const auto [last, code] = std::from_chars(*at, cursor_.end(), number);
    if (code == std::errc::invalid_argument) {
        return cursor_.fail(*at, fmt::format("expected the number of a {}", what));
    }
    const int64_t count = static_cast<int64_t>(poolSize);
    const int64_t resolved = number > 0 ? number - 1 : count + number;
    if (code == std::errc() && number == 0) {
        return cursor_.fail(*at, fmt::format("the {} has number 0; they count from 1", what));
    }
    if (code != std::errc() || resolved < 0 || resolved >= count) {
        return cursor_.fail(*at, fmt::format("there is no {} {}; {} are defined up to here", what,
                                             std::string_view(*at, static_cast<size_t>(last - *at)), count));
    }
    *index = static_cast<int32_t>(resolved);
    *at = last;
    return true;
}

void ObjParser::useMaterial(const char* where) {
    std::string name(cursor_.restOfLine());
    if (name == materialName_) { return; }
    finishPart();
    materialName_ = std::move(name);
    const SourcePlace place = cursor_.placeOf(where);
    materialPlace_ = fmt::format("{}:{}", place.file, place.line);
}

void ObjParser::finishPart() {
    if (builder_.empty()) { return; }
    const std::string& named = !partGroup_.empty() ? partGroup_ : materialName_;
    file.parts.push_back({.name = !named.empty() ? named : fmt::format("part {}", file.parts.size()),
                          .materialName = materialName_,
                          .materialPlace = materialPlace_,
                          .mesh = builder_.finish()});
}

}  // namespace

Result<MeshFile> parseObj(const std::string& text, const std::string& path) {
    ObjParser parser(text, path);
    if (Status parsed = parser.run(); !parsed) { return parsed.error(); }
    return std::move(parser.file);
}

Status readObjMaterials(const std::string& path, MeshFile* file) {
    MaterialResolver resolver(path, file);
    if (Status read = resolver.readLibraries(file->libraries); !read) { return read; }
    for (MeshPart& part : file->parts) {
        part.material = resolver.indexOf(part.materialName, part.materialPlace);
    }
    return {};
}

Result<MeshFile> loadObj(const std::string& path) {
    const Result<std::string> text = readFile(path);
    if (!text) { return text.error(); }
    Result<MeshFile> file = parseObj(*text, path);
    if (file) {
        if (Status read = readObjMaterials(path, &*file); !read) { return read.error(); }
    }
    return file;
}

}  // namespace glint
