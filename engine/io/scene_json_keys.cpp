// The table of JSON keys. A key added here goes into scenes/glint.schema.json and the reader and writer
// beside it.
#include "engine/io/scene_json_keys.h"

#include "engine/base/check.h"

namespace glint {
namespace {

using Keys = std::string_view[];

constexpr Keys kScene = {"$schema", "glint",  "title",      "description", "resolution",
                         "camera",  "render", "textures",   "materials",   "meshes",
                         "objects", "lights", "environment"};
constexpr Keys kCamera = {"position",       "target",          "up",
                          "verticalFovDeg", "horizontalScale", "apertureDiameter",
                          "focalDistance",  "apertureBlades",  "bladeRotationDeg"};
constexpr Keys kRender = {"integrator", "maxDepth", "rouletteStartDepth", "filter", "filterRadiusPixels",
                          "sampler",    "seed",     "fireflyClamp",       "sppm"};
constexpr Keys kSppm = {"photonsPerPass", "alpha",       "radius", "radiusFootprints",
                        "storeRoughness", "directLight", "lookup", "memoryBudgetMiB"};
constexpr Keys kTexture = {"file", "encoding", "flipV", "scale"};
constexpr Keys kTextureUse = {"texture", "fallback"};

constexpr Keys kDiffuse = {"type", "color", "emission", "emissionStrength", "emitsBothSides"};
constexpr Keys kConductor = {
    "type", "color", "metal", "eta", "k", "roughness", "emission", "emissionStrength", "emitsBothSides"};
constexpr Keys kDielectric = {
    "type", "color", "ior", "roughness", "thin", "emission", "emissionStrength", "emitsBothSides"};
constexpr Keys kPlastic = {"type",          "color", "ior", "roughness", "emission", "emissionStrength",
                           "emitsBothSides"};
constexpr Keys kMixture = {"type",          "color", "ior", "weights", "emission", "emissionStrength",
                           "emitsBothSides"};

constexpr Keys kMeshFile = {"file", "part"};
constexpr Keys kMeshGenerator = {"generator", "triangleCount", "seed"};
constexpr Keys kMeshInline = {"positions", "triangles", "normals", "uvs", "colors"};

constexpr Keys kSphere = {"type", "name", "material", "frontOnly", "transform", "center", "radius"};
constexpr Keys kPlane = {"type", "name", "material", "frontOnly", "transform", "point", "normal"};
constexpr Keys kRectangle = {"type",      "name",   "material", "frontOnly",
                             "transform", "center", "edgeU",    "edgeV"};
constexpr Keys kDisc = {"type", "name", "material", "frontOnly", "transform", "center", "normal", "radius"};
constexpr Keys kMesh = {"type", "name", "material", "frontOnly", "transform", "mesh"};

constexpr Keys kTransformStep = {"translate",  "scale",      "rotate", "rotateXDeg",
                                 "rotateYDeg", "rotateZDeg", "matrix"};
constexpr Keys kRotation = {"axis", "angleDeg"};

constexpr Keys kPointLight = {"type", "name", "position", "color", "intensity"};
constexpr Keys kSpotLight = {"type",  "name",      "position",     "direction",
                             "color", "intensity", "coneAngleDeg", "coneFalloffStartDeg"};
constexpr Keys kDirectionalLight = {"type", "name", "direction", "color", "irradiance"};

constexpr Keys kEnvironment = {"color", "strength", "image", "rotationDeg"};
constexpr Keys kEnvironmentFile = {"file"};
constexpr Keys kSky = {"generator",       "zenith",        "horizon",      "ground", "sun",
                       "sunElevationDeg", "sunAzimuthDeg", "sunRadiusDeg", "width"};

constexpr JsonKind kKinds[] = {
    {"scene", kScene},
    {"camera", kCamera},
    {"render", kRender},
    {"sppm", kSppm},
    {"texture", kTexture},
    {"textureUse", kTextureUse},
    {"diffuse", kDiffuse},
    {"mirror", kDiffuse},
    {"conductor", kConductor},
    {"dielectric", kDielectric},
    {"plastic", kPlastic},
    {"mixture", kMixture},
    {"meshFile", kMeshFile},
    {"meshGenerator", kMeshGenerator},
    {"meshInline", kMeshInline},
    {"sphere", kSphere},
    {"plane", kPlane},
    {"rectangle", kRectangle},
    {"disc", kDisc},
    {"mesh", kMesh},
    {"transformStep", kTransformStep},
    {"rotation", kRotation},
    {"point", kPointLight},
    {"spot", kSpotLight},
    {"directional", kDirectionalLight},
    {"environment", kEnvironment},
    {"environmentFile", kEnvironmentFile},
    {"sky", kSky},
};

}  // namespace

std::span<const JsonKind> sceneJsonKinds() { return kKinds; }

std::span<const std::string_view> sceneJsonKeys(std::string_view kind) {
    for (const JsonKind& known : kKinds) {
        if (known.name == kind) { return known.keys; }
    }
    GLINT_CHECK(!"the kind is in the table");
    return {};
}

}  // namespace glint
