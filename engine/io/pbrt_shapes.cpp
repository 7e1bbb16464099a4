#include "engine/io/pbrt_shapes.h"

#include <algorithm>

#include <fmt/format.h>

#include "engine/scene/mesh_area.h"
#include "engine/scene/scene_use.h"

namespace glint {
PbrtShapes::Piece PbrtShapes::ofMesh(int mesh, const Wish& wish) {
    Piece piece;
    piece.isThere = mesh >= 0;
    if (!piece.isThere) { return piece; }
    piece.object.shape = ShapeKind::Mesh;
    piece.object.mesh = mesh;
    if (wish.state.areaLight >= 0 && lights_.needsArea(wish.state.areaLight)) {
        readFiles();
        const auto& data = context_.scene.meshes[static_cast<size_t>(mesh)].data;
        if (!data) { return piece; }  // its file is broken
        piece.parts = data->triangleCount();
        piece.area = areaOf(*data, affineOf(&context_, wish.params.place(), wish.state.transform));
    }
    return piece;
}

PbrtShapes::Piece PbrtShapes::pieceOf(const std::string& kind, const Wish& wish) {
    const bool isReversed = wish.state.isReversed;
    if (kind == "trianglemesh") {
        return ofMesh(meshes_.triangles(wish.params, wish.isTextured, isReversed), wish);
    }
    if (kind == "plymesh") { return ofMesh(meshes_.file(wish.params, wish.isTextured, isReversed), wish); }
    // Glint's rectangles turn their textures over with them.
    const bool mayBeRectangle = kind == "bilinearmesh" && !(isReversed && wish.isTextured);
    if (const auto place = mayBeRectangle ? PbrtMeshes::rectangle(wish.params) : std::nullopt) {
        return rectangle(*place, wish);
    }
    if (kind == "bilinearmesh") { return ofMesh(meshes_.patches(wish.params, isReversed), wish); }
    if (kind == "loopsubdiv") { return ofMesh(meshes_.subdivided(wish.params, isReversed), wish); }
    if (kind == "sphere") { return sphere(wish); }
    if (kind == "disk") { return disk(wish); }
    if (kind == "cylinder") { return cylinder(wish); }
    if (kind == "cone" || kind == "paraboloid" || kind == "hyperboloid") { return oldQuadric(kind, wish); }
    context_.refuse(wish.params.place(), fmt::format("Glint has no shape \"{}\"", kind));
    Piece none;
    none.isThere = false;
    return none;
}

void PbrtShapes::place(const std::string& kind, const PbrtParams& params, const PbrtState& state,
                       bool mayShine, std::vector<Object>* out) {
    const Affine toWorld = affineOf(&context_, params.place(), state.transform);
    if (context_.failed()) { return; }
    PbrtState own = state;
    if (!mayShine && own.areaLight >= 0) {
        params.approximated("area lights within objects do not shine, as in pbrt");
        own.areaLight = -1;
    }
    const PbrtSurface& surface = materials_.surfaceOf(own.material);
    const bool shines = own.areaLight >= 0;
    if (context_.failed() || (!surface.isThere && !shines)) { return; }
    if (!isInvertible(toWorld)) {
        params.approximated("shapes that are flattened are left out");
        return;
    }
    if (kind == "curve") {
        placeCurve(params, own, out);
        return;
    }
    const auto alpha = textures_.number(params, "alpha");
    const MaterialKind model = surface.material.kind;
    const bool isTextured = isAnisotropic(surface.material) || !usedTextures(surface.material).empty() ||
                            (alpha && alpha->image) || surface.share.image ||
                            (shines && lights_.showsImage(own.areaLight));
    Piece piece = pieceOf(kind, {params, own, isTextured, shines || model == MaterialKind::Dielectric});
    if (context_.failed() || !piece.isThere) { return; }
    const PbrtEmission emission =
        shines ? lights_.emissionOf(own.areaLight, piece.area, piece.parts) : PbrtEmission();
    const Vec3 absorption =
        own.interior.empty() ? Vec3(0.0f) : materials_.absorptionIn(own.material, own.interior, params);
    piece.object.material =
        materials_.take(own.material, alpha.value_or(PbrtValue{Vec3(1.0f)}), emission, absorption);
    piece.object.objectToWorld = toWorld * piece.object.objectToWorld;
    if (!isInvertible(piece.object.objectToWorld)) {
        params.approximated("shapes that are flattened are left out");
        return;
    }
    piece.object.name = kind;
    params.passOver({"shadowalpha"});
    params.finish();
    out->push_back(std::move(piece.object));
}

}  // namespace glint
