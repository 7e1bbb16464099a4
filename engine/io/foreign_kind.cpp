#include "engine/io/foreign_kind.h"

#include <span>

#include <fmt/format.h>

#include "engine/io/file_kind.h"
#include "engine/io/importer.h"

namespace glint {
namespace {

struct ForeignKind {
    std::string_view name;
    std::string_view extensions;
    bool (*looksLike)(std::string_view head);
};

bool has(std::string_view head, std::string_view word) { return head.find(word) != std::string_view::npos; }

bool isFbx(std::string_view head) {
    return head.starts_with("Kaydara FBX Binary") || firstText(head).starts_with("; FBX");
}
bool isCollada(std::string_view head) { return has(head, "<COLLADA"); }
bool is3ds(std::string_view head) {
    return head.size() > 8 && head.starts_with("MM") && head[6] == 2 && head[7] == 0;
}
bool isBlend(std::string_view head) { return head.starts_with("BLENDER"); }
bool isUsd(std::string_view head) { return head.starts_with("#usda") || head.starts_with("PXR-USDC"); }
bool isOff(std::string_view head) {
    const std::string_view text = firstText(head);
    return text.starts_with("OFF\n") || text.starts_with("OFF\r") || text.starts_with("COFF");
}
bool isVrml(std::string_view head) { return head.starts_with("#VRML"); }
bool isX3d(std::string_view head) { return has(head, "<X3D"); }
bool isDirectX(std::string_view head) { return head.starts_with("xof 0"); }

constexpr ForeignKind kKinds[] = {{"FBX", ".fbx", isFbx},
                                  {"COLLADA", ".dae", isCollada},
                                  {"3DS", ".3ds", is3ds},
                                  {"Blender", ".blend", isBlend},
                                  {"USD", ".usd .usda .usdc .usdz", isUsd},
                                  {"OFF", ".off", isOff},
                                  {"VRML", ".wrl", isVrml},
                                  {"X3D", ".x3d", isX3d},
                                  {"DirectX", ".x", isDirectX}};

}  // namespace

std::optional<Error> foreignKindError(const std::string& path, std::string_view head, bool byName) {
    const ForeignKind* kind = kindOf(std::span<const ForeignKind>(kKinds), path, head);
    if (kind == nullptr || !(byName || kind->looksLike(head))) { return std::nullopt; }
    return Error{
        fmt::format("is a {} file, which Glint does not read; expected {}", kind->name, listImporters()),
        {.file = path}};
}

}  // namespace glint
