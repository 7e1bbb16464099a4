// What a file of triangles holds, whatever its format: parts in file order, each with one material.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/scene/scene.h"

namespace glint {

/// What a file says of the normals that it does not bring.
enum class Smoothing : int { ByAngle = -1, Off = 0 };  ///< above 0: the number of a group

/// Triangles from one on, until the next run.
struct SmoothingRun {
    uint32_t firstTriangle = 0;
    Smoothing group = Smoothing::ByAngle;
};

/// Faces that follow each other and have one material.
struct MeshPart {
    std::string name;
    std::string materialName;                  ///< as the file calls it; empty: none in force
    int materialLine = 0;                      ///< where it says so
    int material = -1;                         ///< index into MeshFile::materials; -1: not resolved
    std::shared_ptr<MeshData> mesh = {};       ///< never null; the reader's own until the scene is handed out
    std::vector<SmoothingRun> smoothing = {};  ///< empty: all by angle
};

struct MeshFile {
    std::vector<MeshPart> parts;         ///< in file order; never empty, each with at least one triangle
    std::vector<std::string> libraries;  ///< files that hold its materials, as it names them
    std::vector<Material> materials;     ///< those that parts use, in order of first use
    /// What these materials use, not read; paths count from where the file's own path does.
    std::vector<Texture> textures;
    std::vector<std::string> warnings;  ///< `file:line: …`: what is missing, was repaired or left out
    std::vector<std::string> notes;     ///< what was decided where the file is sound, but leaves it open
};

/// What stands in for a part's material where there is none: grey, or white under the part's own colours.
Material unknownMaterial(const MeshPart& part);

/// All parts as one mesh, in file order. Where only some parts have normals or uvs, the others get zeros.
std::shared_ptr<MeshData> joinParts(const std::vector<MeshPart>& parts);

/// More parts than this are joined by their materials' names: an object for each run of faces would cost more
/// than the faces.
constexpr size_t kMostSeparateParts = 10'000;

/// What is added to a scene after a file's own parts and materials, at most: a studio. Where room is made for
/// all at once, room for these spares doubling it.
constexpr size_t kLateComers = 16;

/// Joins parts of one material, in the order in which the materials come first. Where there are more than
/// kMostSeparateParts of these, those that are not defined are one, but for parts with colours of their own;
/// `isDefined` is asked only then. Nothing changes where that leaves as many. False: nothing changed.
bool joinByMaterial(std::vector<MeshPart>* parts, const std::function<bool(const std::string&)>& isDefined);

/// Appends all parts as objects like `prototype`, with the file's own materials and textures, which are not
/// read. `path` is as written in the scene; the textures' paths become relative to the scene's folder.
void appendMeshFile(const MeshFile& file, const std::string& path, const Object& prototype,
                    SceneDescription* scene);

/// The same for a file that keeps its meshes alone: nothing is held twice.
void appendMeshFile(MeshFile&& file, const std::string& path, SceneDescription* scene);

}  // namespace glint
