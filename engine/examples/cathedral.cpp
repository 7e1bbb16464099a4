#include "engine/examples/cathedral.h"

#include <string>
#include <string_view>

#include <fmt/format.h>

namespace glint::examples {
namespace {

constexpr const char* kScene = R"({
  // Written by `glint example cathedral`.
  "glint": 1,
  "title": "A cathedral",
  "description": "A nave of seven bays in the evening, between four lamps under its vault and stained glass that still glows.",
  "resolution": [1280, 720],
  "camera": { "position": [0.85, 2.0, -1.6], "target": [-0.2, 5.6, -20], "verticalFovDeg": 55 },
  "render": { "maxDepth": 12, "fireflyClamp": 20, "integrator": "sppm", "sppm": { "photonsPerPass": 500000, "radius": 0.2, "directLight": "photons" } },
  "textures": {
    "limestone": { "file": "limestone.png", "scale": [0.25, 0.25] },
    "chisel": { "file": "chisel_height.png", "encoding": "linear", "scale": [0.8, 0.8] },
    "ashlar": { "file": "ashlar.png", "scale": [0.25, 0.25] },
    "ashlar height": { "file": "ashlar_height.png", "encoding": "linear", "scale": [0.25, 0.25] },
    "web": { "file": "ashlar.png", "scale": [0.4, 0.4] },
    "web height": { "file": "ashlar_height.png", "encoding": "linear", "scale": [0.4, 0.4] },
    "marble": { "file": "marble.png", "scale": [0.4, 0.4], "filter": "mipmap" },
    "marble height": { "file": "marble_height.png", "encoding": "linear", "scale": [0.4, 0.4], "filter": "mipmap" },
    "wood": { "file": "wood.png", "scale": [0.5, 1] },
    "carpet": { "file": "carpet.png", "filter": "mipmap" },
    "lancet": { "file": "lancet.png" },
    "rose": { "file": "rose.png" }
  },
  "materials": {
    "walls": { "type": "diffuse", "color": { "texture": "ashlar" }, "bump": { "texture": "ashlar height" }, "bumpHeight": 0.02 },
    "vaults": { "type": "diffuse", "color": { "texture": "web" }, "bump": { "texture": "web height" }, "bumpHeight": 0.012 },
    "stone": { "type": "diffuse", "color": { "texture": "limestone" }, "bump": { "texture": "chisel" }, "bumpHeight": 0.006 },
    "floor": { "type": "plastic", "color": { "texture": "marble" }, "roughness": 0.14, "bump": { "texture": "marble height" }, "bumpHeight": 0.004 },
    "wood": { "type": "plastic", "color": { "texture": "wood" }, "roughness": 0.22, "bump": { "texture": "wood" }, "bumpHeight": 0.0012 },
    "carpet": { "type": "diffuse", "color": { "texture": "carpet" } },
    "iron": { "type": "conductor", "metal": "iron", "color": 0.5, "roughness": 0.35 },
    "gold": { "type": "conductor", "metal": "gold", "roughness": 0.14 },
    "cloth": { "type": "diffuse", "color": [0.8, 0.78, 0.72] },
    "wax": { "type": "plastic", "color": [0.85, 0.78, 0.62], "roughness": 0.3 },
    "glass": { "type": "diffuse", "color": 0.03, "emission": { "texture": "lancet" }, "emissionStrength": 9 },
    "rose": { "type": "diffuse", "color": 0.03, "emission": { "texture": "rose" }, "emissionStrength": 10 },
    "globe": { "type": "diffuse", "color": 0, "emission": [1, 0.7, 0.42], "emissionStrength": 700 },
    "lamp": { "type": "diffuse", "color": 0, "emission": [1, 0.6, 0.27], "emissionStrength": 12 },
    "flame": { "type": "diffuse", "color": 0, "emission": [1, 0.6, 0.22], "emissionStrength": 60 }
  },
  "objects": [
    { "type": "mesh", "name": "walls", "mesh": { "file": "walls.ply" }, "material": "walls" },
    { "type": "mesh", "name": "vaults", "mesh": { "file": "vaults.ply" }, "material": "vaults" },
    { "type": "mesh", "name": "stone", "mesh": { "file": "stone.ply" }, "material": "stone" },
    { "type": "mesh", "name": "floor", "mesh": { "file": "floor.ply" }, "material": "floor" },
    { "type": "mesh", "name": "pews", "mesh": { "file": "wood.ply" }, "material": "wood" },
    { "type": "mesh", "name": "carpet", "mesh": { "file": "carpet.ply" }, "material": "carpet" },
    { "type": "mesh", "name": "iron", "mesh": { "file": "iron.ply" }, "material": "iron" },
    { "type": "mesh", "name": "gold", "mesh": { "file": "gold.ply" }, "material": "gold" },
    { "type": "mesh", "name": "altar cloth", "mesh": { "file": "cloth.ply" }, "material": "cloth" },
    { "type": "mesh", "name": "candles", "mesh": { "file": "wax.ply" }, "material": "wax" },
    { "type": "mesh", "name": "stained glass", "mesh": { "file": "glass.ply" }, "material": "glass" },
    { "type": "mesh", "name": "rose", "mesh": { "file": "rose.ply" }, "material": "rose" },
LAMPS
  ]
}
)";

/// The lamps and flames, which are spheres: those are sampled better than triangles.
std::string lampObjects(const CathedralMeshes& meshes) {
    std::string spheres;
    const auto globe = [&](const char* material, double radius, const Vec3d& p) {
        spheres += fmt::format(
            "{}    {{ \"type\": \"sphere\", \"material\": \"{}\", \"center\": [{:.3f}, {:.3f}, {:.3f}], "
            "\"radius\": {} }}",
            spheres.empty() ? "" : ",\n", material, p.x, p.y, p.z, radius);
    };
    const auto drop = [&](const char* material, const Vec3d& scale, const Vec3d& p) {
        spheres += fmt::format(
            "{}    {{ \"type\": \"sphere\", \"material\": \"{}\", \"center\": [0, 0, 0], \"radius\": 1, "
            "\"transform\": "
            "[{{ \"scale\": [{:.3f}, {:.3f}, {:.3f}] }}, {{ \"translate\": [{:.3f}, {:.3f}, {:.3f}] }}] }}",
            spheres.empty() ? "" : ",\n", material, scale.x, scale.y, scale.z, p.x, p.y, p.z);
    };
    for (const Vec3d& p : meshes.globes) {
        globe("globe", 0.2, p);
    }
    for (const Vec3d& p : meshes.lamps) {
        globe("lamp", 0.085, p);
    }
    for (const Vec3d& p : meshes.flames) {
        drop("flame", {0.011, 0.034, 0.011}, p);
    }
    return spheres;
}

std::string replaced(std::string text, std::string_view mark, const std::string& by) {
    return text.replace(text.find(mark), mark.size(), by);
}

}  // namespace

void writeCathedral(const Detail& detail, ExampleFolder* folder) {
    CathedralMeshes meshes;
    meshes.detail = detail;
    addPiers(&meshes);
    addArcades(&meshes);
    addWalls(&meshes);
    addVaults(&meshes);
    addRoseWindow(&meshes);
    addFurniture(&meshes);
    addChandeliers(&meshes);
    addAltar(&meshes);
    folder->mesh("walls.ply", meshes.walls);
    folder->mesh("vaults.ply", meshes.vaults);
    folder->mesh("stone.ply", meshes.stone);
    folder->mesh("floor.ply", meshes.floor);
    folder->mesh("wood.ply", meshes.wood);
    folder->mesh("carpet.ply", meshes.carpet);
    folder->mesh("iron.ply", meshes.iron);
    folder->mesh("gold.ply", meshes.gold);
    folder->mesh("cloth.ply", meshes.cloth);
    folder->mesh("wax.ply", meshes.wax);
    folder->mesh("glass.ply", meshes.glass);
    folder->mesh("rose.ply", meshes.rose);
    paintCathedral(folder);
    folder->text("scene.json", replaced(kScene, "LAMPS", lampObjects(meshes)));
}

}  // namespace glint::examples
