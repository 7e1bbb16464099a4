#include "engine/io/foreign_kind.h"

#include <algorithm>
#include <initializer_list>
#include <span>

#include <fmt/format.h>

#include "engine/io/file_kind.h"
#include "engine/io/image_formats.h"
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
bool isZip(std::string_view head) { return head.starts_with("PK\x03\x04"); }
bool isUsd(std::string_view head) {
    return head.starts_with("#usda") || head.starts_with("PXR-USDC") ||
           (isZip(head) && has(head.substr(0, 256), ".usd"));
}
bool isHtml(std::string_view head) {
    std::string first(firstText(head).substr(0, 14));
    std::ranges::transform(first, first.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return first.starts_with("<!doctype html") || first.starts_with("<html") || first.starts_with("<head");
}
bool isLfsPointer(std::string_view head) {
    return head.starts_with("version https://git-lfs.github.com/spec");
}
bool isPdf(std::string_view head) { return head.starts_with("%PDF-"); }
bool isKtx(std::string_view head) { return head.starts_with("\xabKTX 1"); }
bool isKtx2(std::string_view head) { return head.starts_with("\xabKTX 2"); }
/// The brand of an ISO base media file (ISO/IEC 14496-12).
bool hasBrand(std::string_view head, std::initializer_list<std::string_view> brands) {
    return head.size() >= 12 && head.substr(4, 4) == "ftyp" &&
           std::ranges::find(brands, head.substr(8, 4)) != brands.end();
}
bool isAvif(std::string_view head) { return hasBrand(head, {"avif", "avis"}); }
bool isHeic(std::string_view head) {
    return hasBrand(head, {"heic", "heix", "hevc", "heim", "heis", "mif1", "msf1"});
}
bool isJpegXl(std::string_view head) {
    return head.starts_with("\xff\x0a") || head.starts_with(std::string_view("\0\0\0\x0cJXL ", 8));
}
bool isJpeg2000(std::string_view head) {
    return head.starts_with(std::string_view("\0\0\0\x0cjP  ", 8)) || head.starts_with("\xff\x4f\xff\x51");
}
bool isSvg(std::string_view head) { return has(head, "<svg"); }
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
                                  {"DirectX", ".x", isDirectX},
                                  {"HTML", ".html .htm", isHtml},
                                  {"PDF", ".pdf", isPdf},
                                  {"ZIP", ".zip .3mf", isZip}};

constexpr ForeignKind kImageKinds[] = {
    {"HEIC", ".heic .heif", isHeic}, {"AVIF", ".avif", isAvif},     {"KTX", ".ktx", isKtx},
    {"KTX2", ".ktx2", isKtx2},       {"JPEG XL", ".jxl", isJpegXl}, {"JPEG 2000", ".jp2 .j2k", isJpeg2000},
    {"HTML", ".html .htm", isHtml},  {"SVG", ".svg", isSvg},        {"PDF", ".pdf", isPdf},
    {"ZIP", ".zip", isZip}};

constexpr std::string_view kLfsPointer =
    "is a Git LFS pointer, which stands for the file itself; expected what git lfs pull fetches";

/// The picture's kind by its first bytes, which no text has; null: none.
const ImageFormat* imageAmong(std::string_view head) {
    const bool isText = looksLikeText(head) && (head.empty() || static_cast<uint8_t>(head[0]) < 0x80);
    const ImageFormat* format = isText ? nullptr : imageFormatOf("", head);
    const bool isCertain = format != nullptr && format->name != "TGA";  // which has no mark
    return isCertain ? format : nullptr;
}

}  // namespace

std::optional<Error> foreignKindError(const std::string& path, std::string_view head, bool byName) {
    const auto refuse = [&](std::string_view name, std::string_view what) {
        return Error{fmt::format("is a {} {}; expected {}", name, what, listImporters()), {.file = path}};
    };
    if (isLfsPointer(head)) { return Error{std::string(kLfsPointer), {.file = path}}; }
    const ForeignKind* kind = kindOf(std::span<const ForeignKind>(kKinds), path, head);
    if (kind != nullptr && (byName || kind->looksLike(head))) {
        return refuse(kind->name, "file, which Glint does not read");
    }
    const Importer* importer = importerOf(path, head);
    if (importer != nullptr && importer->looksLike(head)) { return std::nullopt; }
    const ImageFormat* image = imageAmong(head);
    return image != nullptr ? std::optional(refuse(image->name, "picture, no model")) : std::nullopt;
}

std::string foreignImage(const std::string& path, std::string_view head) {
    if (isLfsPointer(head)) { return std::string(kLfsPointer); }
    const ForeignKind* kind = kindOf(std::span<const ForeignKind>(kImageKinds), path, head);
    const std::string is = kind == nullptr ? "is not an image that can be read"
                           : kind->looksLike(head)
                               ? fmt::format("is a {} file, which Glint does not read", kind->name)
                               : fmt::format("is called a {} file, which Glint does not read", kind->name);
    return fmt::format("{}; expected {}", is, listReadableImages());
}

}  // namespace glint
