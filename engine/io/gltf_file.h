// A glTF 2.0 file as tinygltf parses it, checked as far as all of it is concerned. Internal to the glTF
// importer (gltf_*.cpp).
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <tiny_gltf.h>

#include "engine/base/result.h"
#include "engine/io/remarks.h"

namespace glint {

struct GltfFile {
    std::string path;
    tinygltf::Model model;
    uint64_t bytes = 0;  ///< of the file and its buffers, before they are unpacked
    /// The bytes of those images that stand in a data URI; null: the others.
    std::vector<std::shared_ptr<const std::string>> dataImages;
    Remarks remarks;  ///< what is left out or approximated

    Error error(std::string message) const { return {std::move(message), {.file = path}}; }
    void remark(std::string_view kind, std::string_view detail = {}) {
        remarks.add(
            kind, [this] { return path; }, detail);
    }
};

/// A URI without its percent-encoded characters.
std::string gltfPath(const std::string& uri);

/// The JSON of a text or binary file's bytes, and the buffer of a binary one; empty where they end too early.
std::string_view gltfJsonText(std::string_view bytes);
std::string_view gltfBinary(std::string_view bytes);
/// Where the JSON of a file ends whose first 20 bytes or more these are; `fileBytes` for text.
uint64_t gltfJsonEnd(std::string_view head, uint64_t fileBytes);

/// Whether Glint reads an extension of that name: a file that needs another one is refused, and what
/// materials have of others is left out with a remark.
bool readsGltfExtension(std::string_view name);

/// With its buffers, unpacked. Error: the file or a buffer cannot be read, is no glTF 2.x, or needs an
/// extension that is not supported.
Result<std::unique_ptr<GltfFile>> readGltfFile(const std::string& path);

/// An object's extension; null where it has none of that name.
template <class Owner>
const tinygltf::Value* extensionOf(const Owner& owner, const char* name) {
    const auto found = owner.extensions.find(name);
    return found != owner.extensions.end() && found->second.IsObject() ? &found->second : nullptr;
}

/// A member of an extension; `otherwise` where there is none that is a number.
double numberOf(const tinygltf::Value* extension, const char* key, double otherwise);
/// As numberOf(), an int; -1 below it.
int indexOf(const tinygltf::Value* extension, const char* key, int otherwise = -1);

}  // namespace glint
