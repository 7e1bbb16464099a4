#include "engine/examples/living_room.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

namespace glint::examples {
namespace {

constexpr const char* kHead = R"({
  // Written by `glint example living-room`.
  "glint": 1,
  "title": "A living room",
  "description": "An evening: three warm lamps against what is left of the daylight in the window. The lamps' bulbs shine into their shades, and the shades outwards.",
  "resolution": [1280, 720],
  "camera": { "position": [2.1, 1.42, 2.3], "target": [-0.62, 0.86, -0.95], "verticalFovDeg": 45 },
  "render": { "maxDepth": 12, "integrator": "sppm", "sppm": { "photonsPerPass": 500000, "radius": 0.04, "directLight": "photons" } },
  "textures": {
    "planks": { "file": "planks.png", "scale": [0.8, 0.8], "filter": "mipmap" },
    "planks height": { "file": "planks_height.png", "encoding": "linear", "scale": [0.8, 0.8], "filter": "mipmap" },
    "plaster": { "file": "plaster_height.png", "encoding": "linear", "scale": [1.6, 1.6] },
    "oak": { "file": "oak.png", "scale": [0.9, 1.8] },
    "walnut": { "file": "walnut.png", "scale": [0.9, 1.8] },
    "marble": { "file": "marble.png", "scale": [0.8, 1.6], "offset": [0.5, 0.5] },
    "linen": { "file": "linen.png", "scale": [20, 20], "filter": "mipmap" },
    "weave": { "file": "weave_height.png", "encoding": "linear", "scale": [20, 20], "filter": "mipmap" },
    "curtain": { "file": "curtain.png", "scale": [2, 2] },
    "pillow": { "file": "pillow.png", "scale": [3, 3] },
    "leather": { "file": "leather_height.png", "encoding": "linear", "scale": [5, 5] },
    "skin": { "file": "leather_height.png", "encoding": "linear", "scale": [9, 9] },
    "rug": { "file": "rug.png" },
    "painting": { "file": "painting.png" },
    "sketch": { "file": "sketch.png" },
    "photo": { "file": "photo.png" },
    "porcelain": { "file": "porcelain.png", "scale": [4, 4] },
    "leaf": { "file": "leaf.png" },
    "view": { "file": "view.png" }
  },
  "materials": {
    "walls": { "type": "diffuse", "color": [0.62, 0.6, 0.52], "bump": { "texture": "plaster" }, "bumpHeight": 0.0015 },
    "ceiling": { "type": "diffuse", "color": [0.8, 0.79, 0.76] },
    "trim": { "type": "plastic", "color": [0.78, 0.77, 0.74], "roughness": 0.35 },
    "planks": { "type": "plastic", "color": { "texture": "planks" }, "roughness": 0.2, "bump": { "texture": "planks height" }, "bumpHeight": 0.002 },
    "sofa": { "type": "diffuse", "color": { "texture": "linen" }, "bump": { "texture": "weave" }, "bumpHeight": 0.0012 },
    "curtain": { "type": "diffuse", "color": { "texture": "curtain" } },
    "rug": { "type": "diffuse", "color": { "texture": "rug" } },
    "leather": { "type": "plastic", "color": [0.4, 0.16, 0.06], "roughness": 0.28, "bump": { "texture": "leather" }, "bumpHeight": 0.0018 },
    "oak": { "type": "plastic", "color": { "texture": "oak" }, "roughness": 0.3 },
    "walnut": { "type": "plastic", "color": { "texture": "walnut" }, "roughness": 0.22 },
    "brass": { "type": "conductor", "metal": "brass", "roughness": 0.16 },
    "copper": { "type": "conductor", "metal": "copper", "roughness": 0.12 },
    "iron": { "type": "diffuse", "color": 0.03 },
    "paper": { "type": "diffuse", "color": [0.78, 0.72, 0.6] },
    "porcelain": { "type": "plastic", "color": { "texture": "porcelain" }, "roughness": 0.05 },
    "marble": { "type": "plastic", "color": { "texture": "marble" }, "roughness": 0.06 },
    "leaf": { "type": "plastic", "color": { "texture": "leaf" }, "roughness": 0.3 },
    "pot": { "type": "diffuse", "color": [0.5, 0.46, 0.4] },
    "soil": { "type": "diffuse", "color": [0.05, 0.035, 0.02] },
    "pillow 1": { "type": "diffuse", "color": [0.5, 0.17, 0.05], "bump": { "texture": "weave" }, "bumpHeight": 0.001 },
    "pillow 2": { "type": "diffuse", "color": { "texture": "pillow" } },
    "book 1": { "type": "plastic", "color": [0.28, 0.035, 0.03], "roughness": 0.35 },
    "book 2": { "type": "plastic", "color": [0.03, 0.07, 0.16], "roughness": 0.35 },
    "book 3": { "type": "plastic", "color": [0.04, 0.12, 0.07], "roughness": 0.35 },
    "book 4": { "type": "plastic", "color": [0.42, 0.26, 0.09], "roughness": 0.35 },
    "book 5": { "type": "plastic", "color": [0.6, 0.52, 0.38], "roughness": 0.35 },
    "fruit": { "type": "plastic", "color": [0.8, 0.27, 0.02], "roughness": 0.3, "bump": { "texture": "skin" }, "bumpHeight": 0.0008 },
    "wax": { "type": "diffuse", "color": [0.85, 0.8, 0.68] },
    "painting": { "type": "diffuse", "color": { "texture": "painting" } },
    "sketch": { "type": "diffuse", "color": { "texture": "sketch" } },
    "photo": { "type": "diffuse", "color": { "texture": "photo" } },
    "glass": { "type": "dielectric", "ior": 1.5 },

    "shade inside": { "type": "diffuse", "color": [0.85, 0.8, 0.7] },
    "shade": { "type": "diffuse", "color": [0.6, 0.5, 0.38], "emission": [1, 0.6, 0.28], "emissionStrength": 7 },
    "bulb": { "type": "diffuse", "color": 0, "emission": [1, 0.66, 0.36], "emissionStrength": 900 },
    "hall": { "type": "diffuse", "color": 0, "emission": [1, 0.82, 0.62], "emissionStrength": 5 },
    "view": { "type": "diffuse", "color": 0, "emission": { "texture": "view" }, "emissionStrength": 11 }
  },
  "objects": [
    { "type": "rectangle", "name": "light from the hall", "material": "hall", "center": [3.19, 1.05, 1.6], "edgeU": [0, 0, 0.9], "edgeV": [0, 2.05, 0] },
)";

/// A glass of one closed profile, on the dining table.
std::string wineGlass(const Vec3d& foot) {
    return fmt::format(
        R"(    {{ "type": "revolved", "name": "wine glass", "material": "glass", "curve": "bspline",
      "profile": [
        [0, 0.0005], [0, 0.0005], [0, 0.0005], [0.03, 0.0005], [0.035, 0.0005], [0.0355, 0.0025], [0.033, 0.004], [0.008, 0.008],
        [0.0045, 0.02], [0.004, 0.05], [0.0045, 0.078], [0.016, 0.088], [0.037, 0.11], [0.043, 0.14], [0.036, 0.18], [0.033, 0.197],
        [0.0325, 0.2], [0.0315, 0.2], [0.0312, 0.197], [0.0343, 0.18], [0.0412, 0.14], [0.0352, 0.112], [0.0145, 0.093],
        [0.0, 0.0885], [0, 0.0885], [0, 0.0885]
      ], "transform": {{ "translate": [{:.3f}, {:.3f}, {:.3f}] }} }},
)",
        foot.x, foot.y, foot.z);
}

struct NamedMesh {
    const char* material;
    const MeshData* mesh;
};

std::vector<NamedMesh> namedMeshes(const RoomMeshes& r) {
    return {{"walls", &r.walls},     {"ceiling", &r.ceiling},     {"trim", &r.trim},
            {"planks", &r.planks},   {"sofa", &r.sofa},           {"curtain", &r.curtain},
            {"rug", &r.rug},         {"leather", &r.leather},     {"oak", &r.oak},
            {"walnut", &r.walnut},   {"brass", &r.brass},         {"copper", &r.copper},
            {"iron", &r.iron},       {"paper", &r.paper},         {"porcelain", &r.porcelain},
            {"marble", &r.marble},   {"leaf", &r.leaf},           {"pot", &r.pot},
            {"soil", &r.soil},       {"pillow 1", &r.pillows[0]}, {"pillow 2", &r.pillows[1]},
            {"book 1", &r.books[0]}, {"book 2", &r.books[1]},     {"book 3", &r.books[2]},
            {"book 4", &r.books[3]}, {"book 5", &r.books[4]},     {"fruit", &r.fruit},
            {"wax", &r.wax},         {"painting", &r.painting},   {"sketch", &r.sketch},
            {"photo", &r.photo},     {"shade", &r.shade},         {"shade inside", &r.shadeInside},
            {"view", &r.view}};
}

}  // namespace

void writeLivingRoom(const Detail& detail, ExampleFolder* folder) {
    RoomMeshes meshes;
    meshes.detail = detail;
    addShell(&meshes);
    addWindowAndCurtains(&meshes);
    addRug(&meshes);
    addSofa(Pose{{-0.65, 0.0, -2.08}}, &meshes);
    addArmchair(turned({1.25, 0.0, -0.6}, -70.0), &meshes);
    addShelves(Pose{{2.32, 0.0, -room::kHalfZ + 0.16}}, &meshes);
    addCoffeeTable(Pose{{-0.5, 0.0, -0.75}}, &meshes);
    addDiningTable(Pose{{-2.0, 0.0, 1.05}}, &meshes);
    addPlant(Pose{{-2.75, 0.0, -2.1}}, &meshes);
    addLamps(&meshes);
    addImages(&meshes);
    std::string text = kHead;
    for (const NamedMesh& named : namedMeshes(meshes)) {
        std::string file = fmt::format("{}.ply", named.material);
        std::replace(file.begin(), file.end(), ' ', '_');
        folder->mesh(file, *named.mesh);
        text += fmt::format(
            "    {{ \"type\": \"mesh\", \"name\": \"{0}\", \"mesh\": {{ \"file\": \"{1}\" }}, \"material\": "
            "\"{0}\" }},\n",
            named.material, file);
    }
    text += wineGlass({-1.83, 0.748, 1.2}) + wineGlass({-2.12, 0.748, 0.86});
    for (size_t i = 0; i < meshes.bulbs.size(); ++i) {
        const Vec3d& p = meshes.bulbs[i];
        text += fmt::format(
            "    {{ \"type\": \"sphere\", \"name\": \"bulb {}\", \"material\": \"bulb\", \"center\": "
            "[{:.3f}, {:.3f}, {:.3f}], \"radius\": 0.04 }}{}\n",
            i + 1, p.x, p.y, p.z, i + 1 < meshes.bulbs.size() ? "," : "");
    }
    text += "  ]\n}\n";
    paintLivingRoom(folder);
    folder->text("scene.json", text);
}

}  // namespace glint::examples
