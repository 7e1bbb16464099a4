// The binary form: 80 bytes of anything, which may begin with "solid" too, the number of facets, and 50 bytes
// for each of them.
#include "engine/io/stl_loader.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <unordered_map>

#include <fmt/format.h>

#include "engine/io/byte_stream.h"
#include "engine/io/file_kind.h"
#include "engine/io/plain_text.h"
#include "engine/io/polygon.h"
#include "engine/io/text_cursor.h"

namespace glint {
namespace {

constexpr size_t kHeaderBytes = 84;
constexpr size_t kFacetBytes = 50;

struct PositionHash {
    size_t operator()(const Vec3& p) const {
        uint32_t bits[3];
        std::memcpy(bits, &p, sizeof bits);
        uint64_t hash = bits[0] * 0x9e3779b97f4a7c15ull;
        hash = (hash ^ (hash >> 29) ^ bits[1]) * 0xbf58476d1ce4e5b9ull;
        hash = (hash ^ (hash >> 32) ^ bits[2]) * 0x94d049bb133111ebull;
        return static_cast<size_t>(hash ^ (hash >> 31));
    }
};

/// The mesh of a solid in the making.
class Solid {
  public:
    void addCorner(const Vec3& position) {
        const Vec3 p = position + Vec3(0.0f);  // -0 is 0
        const auto [known, isNew] = indices_.try_emplace(p, static_cast<uint32_t>(mesh_->positions.size()));
        if (isNew) { mesh_->positions.push_back(p); }
        mesh_->indices.push_back(known->second);
    }
    bool empty() const { return mesh_->indices.empty(); }
    MeshPart finish(std::string name) {
        MeshPart part{.name = std::move(name), .materialName = {}, .mesh = std::move(mesh_)};
        *this = {};
        return part;
    }

  private:
    std::shared_ptr<MeshData> mesh_ = std::make_shared<MeshData>();
    std::unordered_map<Vec3, uint32_t, PositionHash> indices_;
};

bool isInRange(const Vec3& p) { return maxComponent(absVec(p)) <= kMaxCoordinate; }  // false for NaN

uint64_t facetCount(std::string_view bytes) {
    uint32_t count = 0;
    std::memcpy(&count, bytes.data() + kHeaderBytes - sizeof count, sizeof count);
    return count;
}

/// The coordinates of the facets that lie within the first bytes of a binary file.
struct FirstCoordinates {
    size_t sound = 0, odd = 0, zero = 0;
};

FirstCoordinates firstCoordinates(std::string_view head) {
    constexpr float kLeast = 1e-18f;  // whole numbers of another format, taken for floats, are below it
    FirstCoordinates found;
    if (head.size() < kHeaderBytes) { return found; }
    const uint64_t held = (head.size() - kHeaderBytes) / kFacetBytes;
    ByteReader reader(head.substr(kHeaderBytes));
    for (uint64_t facet = 0; facet < std::min(facetCount(head), held); ++facet) {
        reader.readRaw(3 * sizeof(float));
        for (int i = 0; i < 9; ++i) {
            const float size = std::fabs(reader.read<float>());
            size_t& kind = size == 0.0f                               ? found.zero
                           : size >= kLeast && size <= kMaxCoordinate ? found.sound
                                                                      : found.odd;
            ++kind;
        }
        reader.readRaw(sizeof(uint16_t));
    }
    return found;
}

/// By its size, or by bytes that no text has: some writers leave more behind the last facet.
bool isBinary(const std::string& bytes) {
    if (bytes.size() < kHeaderBytes || bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff")) {
        return false;
    }
    const std::string_view head = headOf(bytes);
    return bytes.size() == kHeaderBytes + facetCount(bytes) * kFacetBytes ||
           std::ranges::any_of(head, [](char c) { return static_cast<uint8_t>(c) < '\t'; });
}

Result<MeshFile> parseBinary(const std::string& bytes, const std::string& path) {
    const uint64_t stated = facetCount(bytes), held = (bytes.size() - kHeaderBytes) / kFacetBytes;
    if (stated > held) {
        return Error{
            fmt::format("the file is cut off, or no STL: it says {} facets, and holds {}", stated, held),
            {.file = path}};
    }
    if (stated == 0) { return Error{"the file has no facets; expected a mesh", {.file = path}}; }
    Solid solid;
    MeshFile file;
    uint64_t colored = 0;
    ByteReader reader(std::string_view(bytes).substr(kHeaderBytes));
    for (uint64_t facet = 0; facet < stated; ++facet) {
        reader.readRaw(3 * sizeof(float));
        for (int corner = 0; corner < 3; ++corner) {
            const Vec3 p{reader.read<float>(), reader.read<float>(), reader.read<float>()};
            if (!isInRange(p)) {
                return Error{
                    fmt::format("facet {} has a coordinate that is no number or above 1e18", facet + 1),
                    {.file = path}};
            }
            solid.addCorner(p);
        }
        colored += reader.read<uint16_t>() != 0 ? 1 : 0;
    }
    if (colored > 0) {
        file.warnings.push_back(
            fmt::format("{}: attributes of facets, which may be colours, are left out ({})", path, colored));
    }
    file.parts.push_back(solid.finish("mesh"));
    return file;
}

class TextParser {
  public:
    TextParser(const std::string& text, const std::string& path) : cursor_(text, path), path_(path) {}

    Result<MeshFile> run() {
        for (; !cursor_.atEnd(); cursor_.nextLine()) {
            while (!cursor_.atLineEnd()) {
                if (!parseWord()) { return cursor_.error(); }
            }
        }
        finishSolid();
        if (file_.parts.empty()) { return Error{"the file has no facets; expected a mesh", {.file = path_}}; }
        file_.warnings = cursor_.remarks().lines();
        return std::move(file_);
    }

  private:
    static bool is(std::string_view word, std::string_view keyword) {
        return std::ranges::equal(
            word, keyword, [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; });
    }

    bool parseWord() {
        const char* where = cursor_.position();
        const std::string_view word = cursor_.word();
        if (is(word, "vertex")) { return parseVertex(); }
        if (is(word, "solid")) {
            finishSolid();
            name_ = cursor_.restOfLine();
        } else if (is(word, "endsolid")) {
            finishSolid();
            cursor_.restOfLine();
        } else if (is(word, "facet")) {
            for (int i = 0; i < 4; ++i) {
                cursor_.word();  // "normal" and its numbers
            }
            corners_.clear();
        } else if (is(word, "endfacet")) {
            return finishFacet(where);
        } else if (is(word, "color")) {
            cursor_.remark(where, "colours are left out");
            cursor_.restOfLine();
        } else if (!is(word, "outer") && !is(word, "loop") && !is(word, "endloop")) {
            return cursor_.fail(where,
                                fmt::format("\"{}\" is no word of an STL file; expected solid, facet, outer "
                                            "loop, vertex, endloop, endfacet or endsolid",
                                            word.substr(0, 40)));
        }
        return true;
    }

    bool parseVertex() {
        Vec3 p;
        const char* where = cursor_.position();
        if (!cursor_.readFloat("x", &p.x) || !cursor_.readFloat("y", &p.y) || !cursor_.readFloat("z", &p.z)) {
            return false;
        }
        if (!isInRange(p)) {
            return cursor_.fail(where, "this coordinate is too large; expected at most 1e18");
        }
        corners_.push_back(p);
        return true;
    }

    bool finishFacet(const char* where) {
        if (corners_.size() < 3) {
            cursor_.remark(where, "facets of fewer than 3 corners are left out");
            return true;
        }
        triangles_.clear();
        if (!triangulatePolygon(corners_, &triangles_)) {
            return cursor_.fail(where, "this facet has too many corners");
        }
        for (const uint32_t corner : triangles_) {
            solid_.addCorner(corners_[corner]);
        }
        return true;
    }

    void finishSolid() {
        if (!solid_.empty()) { file_.parts.push_back(solid_.finish(name_.empty() ? "mesh" : name_)); }
        name_.clear();
    }

    TextCursor cursor_;
    const std::string& path_;
    MeshFile file_;
    Solid solid_;
    std::string name_;
    std::vector<Vec3> corners_;
    std::vector<uint32_t> triangles_;
};

}  // namespace

bool looksLikeBinaryStl(std::string_view head) {
    const FirstCoordinates found = firstCoordinates(head);
    const bool isWhole = head.size() < kHeadBytes;
    return !looksLikeText(head) && found.odd == 0 && found.sound > found.zero / 8 && found.sound > 0 &&
           (!isWhole || head.size() == kHeaderBytes + facetCount(head) * kFacetBytes);
}

bool canBeBinaryStl(std::string_view head) {
    const FirstCoordinates found = firstCoordinates(head);
    return found.odd <= 1 + found.sound / 8 && found.sound + found.odd + found.zero > 0;
}

Result<MeshFile> parseStl(const std::string& bytes, const std::string& path) {
    if (isBinary(bytes)) { return parseBinary(bytes, path); }
    const std::optional<PlainText> plain = asPlainText(bytes);
    if (bytes.size() < kHeaderBytes && bytes.find('\0') != std::string::npos && !plain) {
        return Error{"the file is cut off: a binary STL has a header of 84 bytes", {.file = path}};
    }
    Result<MeshFile> file = TextParser(plain ? plain->text : bytes, path).run();
    if (file && plain) { file->warnings.push_back(fmt::format("{}: {}", path, plain->repaired)); }
    return file;
}

Status readStlMaterials(const std::string&, MeshFile* file) {
    for (MeshPart& part : file->parts) {
        part.material = static_cast<int>(file->materials.size());
        file->materials.push_back(unknownMaterial(part));
    }
    return {};
}

}  // namespace glint
