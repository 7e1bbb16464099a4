// Parts of a glTF file that is written: materials, and shapes as triangles. Internal to the glTF
// exporter (export_gltf.cpp).
#pragma once

#include <string>
#include <vector>

#include "engine/io/gltf_images.h"

namespace glint {

/// Whether a mesh under that material has 1 - v in the file: where its pictures count v from the bottom, so
/// that they need no placement.
bool flipsV(const SceneDescription& scene, int material);

/// Writes a material, and says at which place. `isEmitter`: emission lights the scene, where it could be a
/// screen under some other light (KHR_materials_emissive_strength is above 1 then, and never otherwise by
/// need). What is approximated is appended to `warnings`, each once.
size_t writeGltfMaterial(const SceneDescription& scene, int material, bool isEmitter, GltfImages* images,
                         GltfWriter* out, std::vector<std::string>* warnings);

/// Adds what a principled material has beside its base: coat, sheen, specular reflection and what passes.
/// `isFlipped`: as of GltfImages::info(). What is approximated is appended to `warnings`, each once.
void writeGltfLayers(const Material& material, bool isFlipped, GltfImages* images, GltfWriter* out,
                     GltfJson* to, std::vector<std::string>* warnings);
/// Adds the inside of a material that light passes, unless it is a sheet.
void writeGltfVolume(const Material& material, GltfWriter* out, GltfJson* to);

/// Gives materials with a height map and no normal map the normals of the heights, as steep as they are on
/// the average of the material's objects. False: there were none.
bool makeBumpsNormals(SceneDescription* scene);

/// Whether it is made of a rotation, scales along the axes and a translation, as those of nodes must be.
bool isPlacement(const Affine& toWorld);
/// The place whose -z has this direction and length.
Affine lookingAlong(const Vec3& position, const Vec3& direction);

/// The mesh in the world's space.
MeshData placed(MeshData mesh, const Affine& toWorld);
/// glTF's normals are of unit length, and a mesh has them everywhere or nowhere.
MeshData withUnitNormals(MeshData mesh);
/// Tangents as glTF's, which are of unit length, and of whose sides the top of a normal map is one;
/// `countsFromTop`: the map's flipV. False: the mesh has none any more, since they, or normals, are missing.
bool makeGltfTangents(MeshData* mesh, bool countsFromTop);
/// The flipV of the material's normal map, or of its other textures.
bool tangentsCountFromTop(const SceneDescription& scene, int material);

}  // namespace glint
