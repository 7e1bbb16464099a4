#include "engine/io/gltf_file.h"

#include <algorithm>
#include <cstring>
#include <filesystem>

#include <fmt/format.h>

#include "engine/io/atomic_file.h"
#include "engine/io/file_kind.h"
#include "engine/io/gltf_compression.h"

namespace glint {
namespace {

constexpr int kMaxNesting = 200;  ///< tinygltf reads what lies within by recursion
constexpr size_t kBinaryHeader = 20;

constexpr std::string_view kSupported[] = {"KHR_lights_punctual",
                                           "KHR_texture_transform",
                                           "KHR_mesh_quantization",
                                           "EXT_texture_webp",
                                           "EXT_mesh_gpu_instancing",
                                           "EXT_meshopt_compression",
                                           "KHR_draco_mesh_compression",
                                           "KHR_materials_ior",
                                           "KHR_materials_emissive_strength",
                                           "KHR_materials_unlit",
                                           "KHR_materials_transmission",
                                           "KHR_materials_volume",
                                           "KHR_materials_diffuse_transmission",
                                           "KHR_materials_specular",
                                           "KHR_materials_clearcoat",
                                           "KHR_materials_sheen",
                                           "KHR_materials_anisotropy",
                                           "KHR_materials_iridescence",
                                           "KHR_materials_variants",
                                           "KHR_materials_pbrSpecularGlossiness"};

bool isNestedTooDeeply(std::string_view json) {
    int depth = 0;
    bool inString = false;
    for (size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (inString) {
            i += c == '\\' ? 1 : 0;
            inString = c != '"';
        } else if (c == '"') {
            inString = true;
        } else if (c == '{' || c == '[') {
            if (++depth > kMaxNesting) { return true; }
        } else if (c == '}' || c == ']') {
            --depth;
        }
    }
    return false;
}

bool readBuffer(std::vector<unsigned char>* out, std::string* error, const std::string& path, void*) {
    const Result<std::string> bytes = readFile(path);
    if (!bytes) {
        *error += bytes.error().format() + "\n";
        return false;
    }
    out->assign(bytes->begin(), bytes->end());
    return true;
}

/// Keeps what stands in a data URI; other images are read by whoever uses them.
bool keepImage(tinygltf::Image* image, int index, std::string*, std::string*, int, int,
               const unsigned char* bytes, int size, void* user) {
    auto* images = static_cast<std::vector<std::shared_ptr<const std::string>>*>(user);
    if (image->bufferView >= 0 || !image->uri.empty() || index < 0 || size < 0) { return true; }
    images->resize(std::max(images->size(), static_cast<size_t>(index) + 1));
    (*images)[static_cast<size_t>(index)] =
        std::make_shared<const std::string>(reinterpret_cast<const char*>(bytes), static_cast<size_t>(size));
    return true;
}

Error wrongVersion(const GltfFile& file, std::string_view version) {
    return file.error(fmt::format("is glTF {}; expected 2.0", version));
}

/// Materials and textures say themselves what of them is left out.
Status checkExtensions(GltfFile* file) {
    for (const std::string& name : file->model.extensionsRequired) {
        if (!readsGltfExtension(name)) {
            return file->error(fmt::format(
                "needs {}, which Glint does not read; expected a file that was saved without it", name));
        }
    }
    for (const std::string& name : file->model.extensionsUsed) {
        const bool isOfParts =
            name.find("_materials_") != std::string::npos || name.find("_texture_") != std::string::npos;
        if (!readsGltfExtension(name) && !isOfParts) { file->remark("extensions are left out", name); }
    }
    return {};
}

}  // namespace

bool readsGltfExtension(std::string_view name) {
    return std::ranges::find(kSupported, name) != std::end(kSupported);
}

uint64_t gltfJsonEnd(std::string_view head, uint64_t fileBytes) {
    if (!head.starts_with("glTF")) { return fileBytes; }
    uint32_t length = 0;
    if (head.size() < kBinaryHeader) { return fileBytes; }
    std::memcpy(&length, head.data() + 12, sizeof length);
    return std::min<uint64_t>(kBinaryHeader + uint64_t{length}, fileBytes);
}

std::string gltfPath(const std::string& uri) {
    std::string out;
    for (size_t i = 0; i < uri.size(); ++i) {
        const auto digit = [&uri](size_t at) {
            const char c = at < uri.size() ? uri[at] : 'x';
            return c >= '0' && c <= '9'                 ? c - '0'
                   : (c | 32) >= 'a' && (c | 32) <= 'f' ? (c | 32) - 'a' + 10
                                                        : -1;
        };
        const bool isEncoded = uri[i] == '%' && digit(i + 1) >= 0 && digit(i + 2) >= 0;
        out += isEncoded ? static_cast<char>(16 * digit(i + 1) + digit(i + 2)) : uri[i];
        i += isEncoded ? 2 : 0;
    }
    return out;
}

std::string_view gltfJsonText(std::string_view bytes) {
    if (!bytes.starts_with("glTF")) { return bytes; }
    if (bytes.size() < kBinaryHeader) { return {}; }
    return bytes.substr(0, gltfJsonEnd(bytes, bytes.size())).substr(kBinaryHeader);
}

std::string_view gltfBinary(std::string_view bytes) {
    constexpr size_t kChunkHeader = 8;
    const size_t begin = kBinaryHeader + gltfJsonText(bytes).size() + kChunkHeader;
    uint32_t length = 0;
    if (bytes.size() < begin) { return {}; }
    std::memcpy(&length, bytes.data() + begin - kChunkHeader, sizeof length);
    return bytes.substr(begin, length);
}

Result<std::unique_ptr<GltfFile>> readGltfFile(const std::string& path) {
    const auto canBeGltf = [](std::string_view head) {
        return head.starts_with("glTF") || looksLikeText(head);
    };
    Result<std::string> bytes = readFileOfKind(path, canBeGltf);
    if (!bytes) { return bytes.error(); }
    auto file = std::make_unique<GltfFile>();
    file->path = path;
    if (isNestedTooDeeply(gltfJsonText(*bytes))) {
        return file->error(fmt::format("is nested deeper than {} levels", kMaxNesting));
    }
    if (bytes->starts_with(std::string_view("glTF\1\0\0\0", 8))) { return wrongVersion(*file, "1.0"); }
    *bytes = readableForTinygltf(std::move(*bytes));
    tinygltf::TinyGLTF parser;
    parser.SetImageLoader(keepImage, &file->dataImages);
    parser.SetFsCallbacks({tinygltf::FileExists, tinygltf::ExpandFilePath, readBuffer, nullptr, nullptr});
    const std::string folder = std::filesystem::path(path).parent_path().string();
    std::string error, warning;
    const auto size = static_cast<unsigned>(bytes->size());
    if (bytes->size() > UINT32_MAX) { return file->error("is larger than 4 GiB"); }
    const bool read =
        bytes->starts_with("glTF")
            ? parser.LoadBinaryFromMemory(&file->model, &error, &warning,
                                          reinterpret_cast<const unsigned char*>(bytes->data()), size, folder)
            : parser.LoadASCIIFromString(&file->model, &error, &warning, bytes->data(), size, folder);
    // What it needs may be why it cannot be read.
    if (Status supported = checkExtensions(file.get()); !supported) { return supported.error(); }
    if (!read) {
        constexpr size_t kMost = 200;  // it may hold a whole buffer
        error = error.substr(0, error.find('\n')).substr(0, kMost);
        return file->error("is no glTF file that can be read: " +
                           (error.empty() ? "it is broken or cut off" : error));
    }
    const std::string& version = file->model.asset.version;
    if (!version.starts_with("2.")) { return wrongVersion(*file, version); }
    file->bytes = bytes->size();
    for (const tinygltf::Buffer& buffer : file->model.buffers) {
        file->bytes += buffer.data.size();
    }
    if (Status unpacked = unpackViews(file.get()); !unpacked) { return unpacked.error(); }
    if (Status unpacked = unpackPrimitives(file.get()); !unpacked) { return unpacked.error(); }
    return file;
}

double numberOf(const tinygltf::Value* extension, const char* key, double otherwise) {
    if (extension == nullptr || !extension->Has(key)) { return otherwise; }
    const tinygltf::Value& value = extension->Get(key);
    return value.IsNumber() ? value.GetNumberAsDouble() : otherwise;
}

int indexOf(const tinygltf::Value* extension, const char* key, int otherwise) {
    constexpr double kMost = std::numeric_limits<int>::max();
    const double number = numberOf(extension, key, static_cast<double>(otherwise));
    return number > -1.0 ? static_cast<int>(std::min(number, kMost)) : -1;
}

}  // namespace glint
