// Two readings of a small file: ours finds what is malformed, and where; tinyobjloader's makes the materials.
#include "engine/io/mtl_loader.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string_view>

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include "engine/io/atomic_file.h"
#include "engine/io/text_cursor.h"

namespace glint {
namespace {

constexpr float kBlack = 1e-3f;
constexpr float kOpaqueAbove = 0.5f;

/// What the check learns that tinyobjloader does not keep.
struct MtlNotes {
    const char* place = nullptr;
    bool hasKd = false;
};

using NotesByName = std::map<std::string, MtlNotes, std::less<>>;

int numbersAfter(std::string_view keyword) {
    if (keyword == "Ka" || keyword == "Kd" || keyword == "Ks" || keyword == "Ke" || keyword == "Kt" ||
        keyword == "Tf") {
        return 3;
    }
    const bool one =
        keyword == "Ns" || keyword == "Ni" || keyword == "d" || keyword == "Tr" || keyword == "illum";
    return one ? 1 : 0;
}

/// map_Kd is used; the others would change the picture.
bool isUnusedMap(std::string_view keyword) {
    return keyword != "map_Kd" && keyword != "map_Ka" &&
           (keyword.starts_with("map_") || keyword == "bump" || keyword == "disp" || keyword == "refl" ||
            keyword == "norm");
}

bool checkNumbers(TextCursor& cursor, std::string_view keyword) {
    static constexpr const char* kParts[3] = {"the red part", "the green part", "the blue part"};
    const int count = numbersAfter(keyword);
    for (int i = 0; i < count; ++i) {
        float number = 0.0f;
        const std::string what = fmt::format("{} of {}", count == 3 ? kParts[i] : "the value", keyword);
        if (!cursor.readFloat(what.c_str(), &number)) { return false; }
    }
    return count == 0 || cursor.expectLineEnd("the last number");
}

bool checkLine(TextCursor& cursor, NotesByName* notes, MtlNotes** current,
               std::vector<std::string>* warnings) {
    const char* lineBegin = cursor.position();
    const std::string_view keyword = cursor.word();
    if (keyword == "newmtl") {
        const std::string name(cursor.restOfLine());
        if (name.empty()) { return cursor.fail(cursor.position(), "expected a name after newmtl"); }
        *current = &(*notes)[name];
        if ((*current)->place != nullptr) {
            warnings->push_back(cursor.warning(
                lineBegin, fmt::format("material \"{}\" is defined twice; the first counts", name)));
        } else {
            (*current)->place = lineBegin;
        }
        return true;
    }
    if (numbersAfter(keyword) > 0 && *current == nullptr) {
        return cursor.fail(keyword.data(), fmt::format("expected newmtl before {}", keyword));
    }
    if (isUnusedMap(keyword)) {
        warnings->push_back(
            cursor.warning(lineBegin, fmt::format("{} is not supported and left out", keyword)));
    }
    if (*current != nullptr) { (*current)->hasKd |= keyword == "Kd"; }
    return checkNumbers(cursor, keyword);
}

Vec3 unitColor(const tinyobj::real_t (&rgb)[3]) {
    return glm::clamp(Vec3(rgb[0], rgb[1], rgb[2]), Vec3(0.0f), Vec3(1.0f));
}

bool isTransparent(const tinyobj::material_t& mtl) {
    return mtl.illum == 4 || mtl.illum == 6 || mtl.illum == 7 || mtl.illum == 9 ||
           mtl.dissolve <= kOpaqueAbove;
}

void makeDielectric(const tinyobj::material_t& mtl, Material* out) {
    out->kind = MaterialKind::Dielectric;
    const Vec3 filter = unitColor(mtl.transmittance);
    out->color.value = maxComponent(filter) > kBlack ? filter : Vec3(1.0f);
    out->thin = mtl.ior <= 1.0f;
    out->ior.value = out->thin ? 1.5f : mtl.ior;
}

void makeConductor(const Vec3& reflectance, Material* out) {
    out->kind = MaterialKind::Conductor;
    out->metal.clear();
    out->color.value = Vec3(1.0f);
    const Vec3 r = glm::clamp(reflectance, Vec3(0.0f), Vec3(0.999f));
    out->eta.value = (Vec3(1.0f) - r) / (Vec3(1.0f) + r);
    out->k.value = 2.0f * glm::sqrt(r) / (Vec3(1.0f) + r);
}

Material toGlint(const tinyobj::material_t& mtl, const std::string& name, bool hasKd) {
    Material out;
    out.name = name;
    out.emission.value = glm::max(Vec3(mtl.emission[0], mtl.emission[1], mtl.emission[2]), Vec3(0.0f));
    out.emitsBothSides = out.emissive();
    const bool mirrorLike = mtl.illum == 3 || mtl.illum == 5;
    const Vec3 diffuse = hasKd || !mtl.diffuse_texname.empty() ? unitColor(mtl.diffuse) : Vec3(0.5f);
    const Vec3 specular = mtl.illum == 0 || mtl.illum == 1 ? Vec3(0.0f) : unitColor(mtl.specular);
    const bool isBlackBase = maxComponent(diffuse) <= kBlack && mtl.diffuse_texname.empty();
    out.color.value = diffuse;
    out.roughness.value =
        mirrorLike ? 0.0f : clampf(std::sqrt(2.0f / (std::max(mtl.shininess, 0.0f) + 2.0f)), 0.0f, 1.0f);
    if (isTransparent(mtl)) {
        out.roughness.value = 0.0f;
        makeDielectric(mtl, &out);
    } else if (maxComponent(specular) <= kBlack) {
        out.roughness.value = 0.0f;
    } else if (isBlackBase && mirrorLike) {
        out.kind = MaterialKind::Mirror;
        out.color.value = specular;
    } else if (isBlackBase) {
        makeConductor(specular, &out);
    } else {
        out.kind = MaterialKind::Plastic;
        out.ior.value = mtl.ior > 1.0f ? mtl.ior : 1.5f;
    }
    return out;
}

std::string trimmed(std::string_view text) {
    const size_t first = text.find_first_not_of(" \t\r");
    const size_t last = text.find_last_not_of(" \t\r");
    return first == std::string_view::npos ? std::string()
                                           : std::string(text.substr(first, last - first + 1));
}

/// tinyobjloader knows no backslash at a line's end.
std::string withJoinedLines(std::string text) {
    for (size_t at = text.find("\\\n"); at != std::string::npos; at = text.find("\\\n", at)) {
        text.replace(at, 2, "  ");
    }
    return text;
}

Status checkFile(TextCursor& cursor, NotesByName* notes, std::vector<std::string>* warnings) {
    MtlNotes* current = nullptr;
    for (; !cursor.atEnd(); cursor.nextLine()) {
        if (!cursor.atLineEnd() && !checkLine(cursor, notes, &current, warnings)) { return cursor.error(); }
    }
    return {};
}

}  // namespace

Result<std::vector<MtlMaterial>> loadMtl(const std::string& path, std::vector<std::string>* warnings) {
    const Result<std::string> text = readFile(path);
    if (!text) { return text.error(); }
    TextCursor cursor(*text, path);
    NotesByName notes;
    if (Status checked = checkFile(cursor, &notes, warnings); !checked) { return checked.error(); }
    std::map<std::string, int> indexByName;
    std::vector<tinyobj::material_t> found;
    std::string ignoredWarning;
    std::string ignoredError;
    std::istringstream stream(withJoinedLines(*text));
    tinyobj::LoadMtl(&indexByName, &found, &stream, &ignoredWarning, &ignoredError);

    std::vector<MtlMaterial> out;
    for (const tinyobj::material_t& mtl : found) {
        const std::string name = trimmed(mtl.name);
        const auto note = notes.find(name);
        if (note == notes.end()) {
            continue;  // tinyobjloader's placeholder of a file without materials
        }
        const char* place = note->second.place;
        MtlMaterial entry{.material = toGlint(mtl, name, note->second.hasKd),
                          .colorMap = trimmed(mtl.diffuse_texname),
                          .colorMapScale = {mtl.diffuse_texopt.scale[0], mtl.diffuse_texopt.scale[1]},
                          .colorMapWarningPlace = fmt::format("{}:{}", path, cursor.placeOf(place).line)};
        if (!isTransparent(mtl) && mtl.dissolve < 1.0f) {
            warnings->push_back(cursor.warning(
                place, fmt::format("material \"{}\" is partly transparent (d {}); it is rendered opaque",
                                   name, mtl.dissolve)));
        }
        out.push_back(std::move(entry));
    }
    return out;
}

}  // namespace glint
