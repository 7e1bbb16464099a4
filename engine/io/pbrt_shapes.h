// pbrt's shapes as objects. Internal to the pbrt importer.
#pragma once

#include <string>
#include <vector>

#include "engine/io/pbrt_lights.h"
#include "engine/io/pbrt_materials.h"
#include "engine/io/pbrt_meshes.h"
#include "engine/io/pbrt_state.h"

namespace glint {

class PbrtShapes {
  public:
    PbrtShapes(PbrtContext* context, PbrtTextures* textures, PbrtMaterials* materials, PbrtLights* lights)
        : context_(*context),
          textures_(*textures),
          materials_(*materials),
          lights_(*lights),
          meshes_(context) {}

    /// Appends what a Shape directive places, if anything; objects are not yet where the world is.
    /// `mayShine`: not within an object that instances place.
    void place(const std::string& kind, const PbrtParams& params, const PbrtState& state, bool mayShine,
               std::vector<Object>* out);
    /// Curves from here on are another mesh than those before.
    void endCurves() { curves_ = {}; }
    /// Reads the mesh files, which are empty until then. Their first error is the first of all.
    void readFiles() { meshes_.readFiles(); }

  private:
    /// A shape in the making.
    struct Piece {
        Object object;  ///< its transform is that to the shape's own space
        double area = 0.0;
        size_t parts = 1;
        bool isThere = true;
    };
    struct Wish {
        const PbrtParams& params;
        const PbrtState& state;
        bool isTextured;
        bool needsSides;  ///< it makes a difference which side is the front
    };
    /// A mesh of curves that goes on.
    struct Curves {
        std::shared_ptr<MeshData> mesh = {};
        int material = -1;
        glm::dmat4 transform{1.0};
    };

    Piece pieceOf(const std::string& kind, const Wish& wish);
    Piece rectangle(const Affine& place, const Wish& wish);
    Piece sphere(const Wish& wish);
    Piece disk(const Wish& wish);
    Piece cylinder(const Wish& wish);
    Piece oldQuadric(const std::string& kind, const Wish& wish);
    Piece ofMesh(int mesh, const Wish& wish);
    void placeCurve(const PbrtParams& params, const PbrtState& state, std::vector<Object>* out);

    PbrtContext& context_;
    PbrtTextures& textures_;
    PbrtMaterials& materials_;
    PbrtLights& lights_;
    PbrtMeshes meshes_;
    Curves curves_;
};

}  // namespace glint
