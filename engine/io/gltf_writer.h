// The text and the buffer of a glTF file that is written. Internal to the glTF exporter (export_gltf.cpp).
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "engine/math/vec.h"
#include "engine/scene/mesh_data.h"

namespace glint {

using GltfJson = nlohmann::ordered_json;

/// With the fewest digits that give the same float back.
GltfJson gltfJson(float value);
GltfJson gltfJson(std::span<const float> values);
inline GltfJson gltfJson(const Vec2& v) { return gltfJson(std::span(&v.x, 2)); }
inline GltfJson gltfJson(const Vec3& v) { return gltfJson(std::span(&v.x, 3)); }

/// The document as text. Names from foreign files may hold anything.
std::string dumpedGltf(const GltfJson& document);
/// A binary file (section 4.4).
std::string binaryGltf(std::string json, std::string_view buffer);

/// A relative path as a URI.
std::string gltfUri(const std::string& path);

class GltfWriter {
  public:
    GltfWriter();

    /// Appends to one of the document's arrays ("nodes"), and says at which place.
    size_t add(const char* array, GltfJson object);
    /// A node of the scene.
    void addNode(GltfJson node);
    /// One of KHR_lights_punctual, as a node has it.
    GltfJson addLight(GltfJson light);
    /// The members of an extension, which is then listed as used.
    void extend(GltfJson* object, const char* extension, GltfJson members);

    /// A view of these bytes, which start at a multiple of four.
    size_t addView(std::string_view bytes);
    /// A primitive of the mesh, without its material; `flipV`: v is counted from the image's top. Normals and
    /// tangents are glTF's already (gltf_export.h).
    GltfJson addPrimitive(const MeshData& mesh, bool flipV);

    const std::string& buffer() const { return buffer_; }
    /// The whole file; of text, the buffer is in a file of that name.
    std::string text(const std::string& bufferUri);
    std::string binary();

  private:
    size_t addAccessor(std::string_view bytes, int target, int componentType, size_t count, const char* type);
    template <class Vector>
    size_t addVectors(std::span<const Vector> values);

    GltfJson document_;
    std::string buffer_;
};

}  // namespace glint
