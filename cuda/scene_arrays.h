// Every array that a SceneView points to, listed once, with its length.
//
// device_scene.cpp walks the list to upload and to redirect each pointer. A kernel view that gains a pointer
// changes its size, and the assertions here ask for the new entry.
#pragma once

#include "engine/kernels/profile_view.h"
#include "engine/kernels/scene_view.h"
#include "engine/kernels/texture.h"
#include "engine/kernels/triangle_cluster.h"

namespace glint {

/// Calls visit(pointer, count) with a reference to each pointer of a mesh.
template <class Visit>
void forEachArray(MeshView& mesh, Visit&& visit) {
    static_assert(sizeof(MeshView) == 136, "list a new array of MeshView below");
    visit(mesh.accelerator.data, mesh.accelerator.bytes);
    visit(mesh.clusters, size_t{mesh.clusterCount});
    visit(mesh.clusterPrimitives, size_t{mesh.clusterTriangles});
    visit(mesh.positions, size_t{mesh.vertexCount});
    visit(mesh.indices, 3 * size_t{mesh.triangleCount});
    visit(mesh.normals, size_t{mesh.vertexCount});
    visit(mesh.uvs, size_t{mesh.vertexCount});
    visit(mesh.colors, size_t{mesh.vertexCount});
    visit(mesh.tangents, size_t{mesh.vertexCount});
    visit(mesh.ownTangents, size_t{mesh.vertexCount});
}

template <class Visit>
void forEachArray(TextureView& texture, Visit&& visit) {
    static_assert(sizeof(TextureView) == 88, "list a new array of TextureView below");
    const size_t texels = static_cast<size_t>(texture.width) * static_cast<size_t>(texture.height);
    visit(texture.bytes, 3 * texels);
    visit(texture.floats, 3 * texels);
    visit(texture.alpha, texels);
    visit(texture.mips, mipValues(texture.width, texture.height));
}

template <class Visit>
void forEachArray(EnvironmentView& environment, Visit&& visit) {
    static_assert(sizeof(EnvironmentView) == 56, "list a new array of EnvironmentView below");
    const size_t width = static_cast<size_t>(environment.width);
    const size_t height = static_cast<size_t>(environment.height);
    visit(environment.texels, 3 * width * height);
    visit(environment.bytes, 3 * width * height);
    visit(environment.decoded, size_t{256});
    visit(environment.rowCdf, height + 1);
    visit(environment.columnCdf, height * (width + 1));
}

template <class Visit>
void forEachArray(PortalView& portal, Visit&& visit) {
    static_assert(sizeof(PortalView) == 104, "list a new array of PortalView below");
    const size_t side = static_cast<size_t>(portal.size) + 1;
    visit(portal.sums, portal.size > 0 ? side * side : 0);
}

/// The scene's own arrays but for the tables of meshes and textures, whose entries hold pointers themselves.
template <class Visit>
void forEachArray(SceneView& view, Visit&& visit) {
    static_assert(sizeof(GeometryView) == 176 && sizeof(LightView) == 248, "list a new array below");
    const auto visitView = [&](auto& array) { visit(array.data, size_t{array.count}); };
    visitView(view.geometry.instances);
    visitView(view.geometry.profiles);
    visitView(view.geometry.curves);
    visitView(view.geometry.pieces);
    visitView(view.geometry.groups);
    visit(view.geometry.topLevel.data, view.geometry.topLevel.bytes);
    visitView(view.geometry.topItems);
    visitView(view.geometry.planes);
    visitView(view.materials);
    visitView(view.coats);
    visitView(view.spectrum);
    visitView(view.lights.emitters);
    visitView(view.lights.nodes);
    visitView(view.lights.emitterNodes);
    visitView(view.lights.castLights);
    forEachArray(view.lights.environment, visit);
    forEachArray(view.lights.portal, visit);
}

}  // namespace glint
