#include "engine/io/gltf_compression.h"

#include "engine/io/gltf_writer.h"

namespace glint {
namespace {

/// The array's objects, if it has that array.
template <class Visit>
void forEachObject(GltfJson* owner, const char* array, const Visit& visit) {
    if (!owner->is_object() || !owner->contains(array) || !(*owner)[array].is_array()) { return; }
    for (GltfJson& object : (*owner)[array]) {
        if (object.is_object()) { visit(&object); }
    }
}

}  // namespace

std::string readableForTinygltf(std::string bytes) {
    const std::string_view json = gltfJsonText(bytes);
    const auto has = [json](const char* extension) { return json.find(extension) != std::string_view::npos; };
    if (!has(kMeshopt) && !has(kDraco)) { return bytes; }
    GltfJson document = GltfJson::parse(json, nullptr, false);
    if (!document.is_object()) { return bytes; }
    const bool isBinary = bytes.starts_with("glTF");
    bool isFirst = true;
    forEachObject(&document, "buffers", [&](GltfJson* buffer) {
        const bool isInFile = isBinary && isFirst;
        isFirst = false;
        if (buffer->contains("uri") || isInFile || !has(kMeshopt)) { return; }
        (*buffer)["uri"] = "data:application/octet-stream;base64,AA==";
        (*buffer)["byteLength"] = 1;
    });
    forEachObject(&document, "meshes", [](GltfJson* mesh) {
        forEachObject(mesh, "primitives", [](GltfJson* primitive) {
            const auto extensions = primitive->find("extensions");
            const bool isPacked =
                extensions != primitive->end() && extensions->is_object() && extensions->contains(kDraco);
            if (isPacked) { primitive->erase("indices"); }
        });
    });
    return isBinary ? binaryGltf(document, gltfBinary(bytes)) : dumpedGltf(document);
}

}  // namespace glint
