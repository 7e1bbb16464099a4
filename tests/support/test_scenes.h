// Scenes made in code for tests: small, deterministic, and between them in need of every kernel feature.
//
// For tests of back ends, builders, sessions and files. Not for pictures that people look at: those are
// in scenes/.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/scene/scene_building.h"

namespace glint::test {

/// Five walls, a lamp and two diffuse spheres, 2 m wide, seen from the front. 64 x 64 pixels.
SceneDescription cornellBox();

/// A sphere of each material kind, smooth and rough, on a textured plane under a lamp, a point, a spot and a
/// directional light, with a thin lens.
SceneDescription allMaterials();

/// A sphere of each material kind that has inputs beside its colour, all of them textures.
SceneDescription texturedInputs();

/// One mesh with normals, texture coordinates and vertex colours, placed by a rigid, a mirrored, a sheared
/// and a non-uniform transform, one of them seen from its front only, under a rotated environment image.
SceneDescription meshInstances();

/// A room lit by a mesh of `triangles` small emissive triangles: enough of them for the light tree.
SceneDescription manyLights(uint32_t triangles = 400);

/// An ellipsoid, a disc, a sheared rectangle and a triangle mesh as lamps, one- and two-sided.
SceneDescription emitterShapes();

/// A white sphere in a uniform environment, by the independent sampler and a box filter.
SceneDescription whiteFurnace();

/// An object of every shape without any light: a black picture.
SceneDescription darkness();

/// Surfaces of revolution of both kinds of curves, and a texture that is placed.
SceneDescription turnedProfiles();
/// All shapes, the meshes under several transforms, in kd-trees.
SceneDescription kdTrees();

/// Height and normal maps, cut-outs by number, texture and alpha, and a mip map.
SceneDescription reliefs();

/// A smooth and a rough ball of glass that bends colours apart, in a box.
SceneDescription dispersiveBalls();

struct NamedScene {
    std::string name;
    SceneDescription scene;
};

/// All of the above.
std::vector<NamedScene> allTestScenes();

/// A bumpy sphere of radius 1 with normals, texture coordinates and, if asked for, vertex colours.
std::shared_ptr<const MeshData> bumpySphere(int rings, int segments, bool withColors);

/// A small image with distinct texels; `floats` picks ImageF instead of Image8.
SceneImage checkerImage(int width, int height, bool floats);

}  // namespace glint::test
