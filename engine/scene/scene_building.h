// Building blocks of scenes that are made in code: by the stability suite, benchmarks and tests.
#pragma once

#include <memory>

#include "engine/scene/scene.h"

namespace glint {

/// No objects and no light, seen from `from` towards `to`; `size` pixels square, box filter of one pixel.
SceneDescription emptyScene(const Vec3& from, const Vec3& to, float fovDeg, int size);

Material diffuseMaterial(const Vec3& color);
inline Material diffuseMaterial(float albedo) { return diffuseMaterial(Vec3(albedo)); }
/// Black, and emits `radiance` from the front, or from both sides.
Material emissiveMaterial(const Vec3& radiance, bool bothSides = false);

Light directionalLight(const Vec3& direction, const Vec3& color = Vec3(1.0f));

/// Each adds one thing and returns its index.
int addMaterial(SceneDescription* scene, Material material);
int addMesh(SceneDescription* scene, std::shared_ptr<const MeshData> data);
size_t addObject(SceneDescription* scene, ShapeKind shape, const Affine& objectToWorld, int material);
size_t addMeshObject(SceneDescription* scene, int mesh, const Affine& objectToWorld, int material);

/// The same with a material, and a mesh, of the object's own.
size_t addObject(SceneDescription* scene, ShapeKind shape, const Affine& objectToWorld,
                 const Material& material);
size_t addMeshObject(SceneDescription* scene, MeshData mesh, const Affine& objectToWorld,
                     const Material& material);

/// The rectangle or disc at `center`, its front towards `normal`, half edges halfX and halfY.
Affine placeFlatShape(const Vec3& center, const Vec3& normal, float halfX, float halfY);

/// Appends two triangles, counter-clockwise seen from where a, b, c, d run counter-clockwise.
void addQuad(MeshData* mesh, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
/// Appends the six inward- or outward-facing sides of the box.
void addBox(MeshData* mesh, const Vec3& lo, const Vec3& hi, bool inward);

}  // namespace glint
