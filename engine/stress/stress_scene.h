// Scenes and materials that families of the stability suite share, and the changes of unit and place that
// must not matter.
//
// Scenes are small descriptions made in code; none reads a file.
#pragma once

#include <string>

#include "engine/scene/scene_building.h"

namespace glint {

/// As emptyScene(), small.
inline SceneDescription emptyStressScene(const Vec3& from, const Vec3& to, float fovDeg, int size = 16) {
    return emptyScene(from, to, fovDeg, size);
}

/// A metal without absorption: everything is reflected (Fresnel 1 up to 1e-6).
Material whiteMetal(float roughness);
Material glass(float ior);

constexpr float kFloorAlbedo = 0.5f;
/// The infinite grey plane y = 0 around `target`, direct light only, in a picture that covers next to nothing
/// of it: `width` across.
SceneDescription closeUpOfFloor(const Vec3& from, const Vec3& target, float width);

/// A grey floor under an even sky, looked at so closely that the picture is `width` across. `tilted` places
/// it by a rotation and looks at it along.
SceneDescription skyOverMesh(MeshData mesh, float width, bool tilted);

/// A room with a lamp, a glass ball, a rough gold block and a plastic one, five units across and not
/// symmetric, seen through a lens in focus on the ball.
SceneDescription stressRoom();

/// The same kind of room with every place on a grid of half a unit, a tenth of its size: floats hold it
/// exactly up to a million times its size from the origin, so that moving it rounds nothing.
SceneDescription gridRoom();

/// How a scene changes its unit or its place: the vertices themselves, or the objects' transforms.
enum class StressChange { Vertices, Transforms };

/// The same picture with all lengths multiplied by `factor`.
SceneDescription scaledScene(const SceneDescription& scene, float factor, StressChange change);
/// The same picture with everything moved by `offset`.
SceneDescription movedScene(const SceneDescription& scene, const Vec3& offset, StressChange change);

/// "1e-6", "0.5", "4": how grades write numbers.
std::string gradeNumber(double value);
template <class Number>
std::string gradeNumber(Number value) {
    return gradeNumber(static_cast<double>(value));
}

}  // namespace glint
