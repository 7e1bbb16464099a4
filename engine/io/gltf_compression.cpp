#include "engine/io/gltf_compression.h"

#include <utility>

#include "engine/io/gltf_writer.h"

namespace glint {
namespace {

/// Sorted, so that very many members are found fast.
using Json = nlohmann::json;

/// The array's objects, if it has that array.
template <class Visit>
void forEachObject(Json* owner, const char* array, const Visit& visit) {
    if (!owner->is_object() || !owner->contains(array) || !(*owner)[array].is_array()) { return; }
    for (Json& object : (*owner)[array]) {
        if (object.is_object()) { visit(&object); }
    }
}

}  // namespace

std::string readableForTinygltf(std::string bytes) {
    const std::string_view json = gltfJsonText(bytes);
    const auto has = [json](const char* extension) { return json.find(extension) != std::string_view::npos; };
    if (!has(kMeshopt) && !has(kDraco)) { return bytes; }
    Json document = Json::parse(json, nullptr, false);
    if (!document.is_object()) { return bytes; }
    const bool isBinary = bytes.starts_with("glTF");
    bool isFirst = true;
    forEachObject(&document, "buffers", [&](Json* buffer) {
        const bool isInFile = isBinary && isFirst;
        isFirst = false;
        if (buffer->contains("uri") || isInFile || !has(kMeshopt)) { return; }
        (*buffer)["uri"] = "data:application/octet-stream;base64,AA==";
        (*buffer)["byteLength"] = 1;
    });
    forEachObject(&document, "meshes", [](Json* mesh) {
        forEachObject(mesh, "primitives", [](Json* primitive) {
            const auto extensions = primitive->find("extensions");
            const bool isPacked =
                extensions != primitive->end() && extensions->is_object() && extensions->contains(kDraco);
            if (isPacked) { primitive->erase("indices"); }
        });
    });
    std::string text = document.dump(-1, ' ', false, Json::error_handler_t::replace);
    return isBinary ? binaryGltf(std::move(text), gltfBinary(bytes)) : text;
}

}  // namespace glint
