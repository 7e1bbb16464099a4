// Lights as kernels see them: emitters of every kind, how one is chosen, and the environment. Plain data.
//
// Filled by builders/light_table, read by light_sampling.h. All of it is in world space: no transform is
// needed to sample a light, except for ellipsoids, which use their instance's.
#pragma once

#include "engine/base/kinds.h"
#include "engine/base/view.h"
#include "engine/math/vec.h"

namespace glint {

enum class EmitterKind : uint8_t {
    Shape,  ///< of EmitterData::shape; for meshes, one triangle
    Point,
    Spot,
    Directional,
    Projector,
    Goniometric,
    Environment,
};

GLINT_HD constexpr bool isDeltaLight(EmitterKind kind) {
    return kind == EmitterKind::Point || kind == EmitterKind::Spot || kind == EmitterKind::Directional ||
           kind == EmitterKind::Projector || kind == EmitterKind::Goniometric;
}

/// One light that can be chosen. Area emitters stand in the order of SceneDescription::objects, the triangles
/// of an emissive mesh in order and without gaps (degenerate ones included, with area 0).
struct EmitterData {
    /// centre of sphere, ellipsoid, rectangle, disc; triangle: vertex 0; lights that are points: position
    Vec3 position{0.0f};
    /// rectangle, disc: images of the unit half axes; triangle: vertex 1 - vertex 0; projector: half the
    /// picture's width, to its right, on the plane at a distance of 1; goniometric: unit, to its right
    Vec3 axisU{0.0f};
    Vec3 axisV{0.0f};      ///< likewise, upwards; triangle: vertex 2 - vertex 0
    Vec3 direction{0.0f};  ///< flat shapes: unit normal of the front; else unit, where the light travels
                           ///< or, goniometric, the middle of the picture
    /// area: W/(sr m^2), with an emission texture about its mean; point, spot: W/sr; directional: W/m^2
    /// facing it; projector: the same 1 m away, before its texture; goniometric: W/sr, likewise
    Vec3 radiance{0.0f};
    /// rectangle, parallelogram, disc, triangle: area; directional: luminance of `radiance`;
    /// projector, goniometric: the mean luminance of its texture, or 1
    float area = 0.0f;
    float radiusWorld = 0.0f;       ///< sphere
    float oneMinusCosOuter = 2.0f;  ///< spot: the light ends here; narrow cones' cosines have no digits left
    float oneMinusCosInner = 2.0f;  ///< spot: begins to fall off here
    uint32_t instance = 0;          ///< area emitters: index into GeometryView::instances
    /// triangle: the emitter that this one repeats and that is sampled in its stead, or its own index;
    /// projector, goniometric: its texture, or kNone
    uint32_t original = 0;
    EmitterKind kind = EmitterKind::Shape;
    ShapeKind shape = ShapeKind::Sphere;
    /// the transform keeps the shape's angles: a sphere stays a sphere, a rectangle a rectangle
    bool keepsAngles = false;
    bool emitsBothSides = false;

    bool operator==(const EmitterData&) const = default;
};

/// Bounds of where a light or a group of lights is, where it shines and how strongly (Conty Estevez and Kulla
/// 2018): the lights lie within `radius` of `center`, emit around normals within acos(cosNormals) of `axis`,
/// and each of them up to acos(cosEmission) away from its normal. `intensity` is the sum of the greatest
/// radiant intensities (luminance, W/sr).
struct LightNode {
    Vec3 center{0.0f};
    float radius = 0.0f;
    Vec3 axis{0.0f, 0.0f, 1.0f};
    float cosNormals = -1.0f;
    float cosEmission = 0.0f;
    float intensity = 0.0f;
    uint32_t child = 0;   ///< inner node: its children are child and child + 1; leaf: index of the emitter
    uint32_t parent = 0;  ///< tree only; the root is its own parent
    bool isLeaf = true;
    bool bothSides = false;  ///< some light also emits around the opposite of its normal

    bool operator==(const LightNode&) const = default;
};

/// A lat-long image around the scene and the distribution that samples it. Row 0 is +y, the middle column is
/// -z, and columns run to the right seen from inside (towards +x from -z). Empty: width 0.
struct EnvironmentView {
    const float* texels = nullptr;     ///< linear RGB, 3 a texel; null: `bytes` are the texels
    const uint8_t* bytes = nullptr;    ///< likewise, as indices into `decoded`
    const float* decoded = nullptr;    ///< the linear values of all 256 bytes
    const float* rowCdf = nullptr;     ///< height + 1 entries, from 0 to 1
    const float* columnCdf = nullptr;  ///< height rows of width + 1 entries, each from 0 to 1
    int width = 0;
    int height = 0;
    float cosRotation = 1.0f;  ///< about +y, counter-clockwise seen from above
    float sinRotation = 0.0f;
};

/// The rectangle through which alone an environment shines. Where there is an image, its radiance is
/// summed over a square that spans the directions out of the portal: its columns and rows are equal steps
/// of the angles, from -90 to 90 degrees, between the portal's normal and the direction's projections
/// along the portal's edges (Bitterli, Novak and Jarosz 2015), so that what is seen of it from any place
/// is a rectangle.
struct PortalView {
    /// as of a rectangle's emitter that lights what lies before its front; area 0: there is no portal
    EmitterData opening;
    /// (size + 1)^2 sums of the cells of radiance times solid angle with a smaller row and column, row by row
    const double* sums = nullptr;
    int size = 0;  ///< cells along either side; 0: the environment is constant
};

/// Up to this many finite emitters are weighed one by one at every shading point; more get a tree.
constexpr uint32_t kFewLights = 8;

struct LightView {
    /// area, point and spot lights first, then directional ones, then the environment
    View<EmitterData> emitters;
    /// usesTree: the tree, root first; otherwise one leaf for each finite emitter, in order
    View<LightNode> nodes;
    View<uint32_t> emitterNodes;  ///< usesTree: the leaf of each finite emitter; otherwise empty
    uint32_t finiteCount = 0;     ///< emitters[0 .. finiteCount) have a place, the rest are infinitely far
    bool usesTree = false;
    bool environmentIsSeenOnly = false;  ///< by rays from the camera: then it is no emitter
    /// luminance times pi, averaged over all directions: weighs its choice; with a portal what falls on that
    float environmentIrradiance = 0.0f;
    Vec3 environmentRadiance{0.0f};  ///< constant environment; multiplies the image where there is one
    EnvironmentView environment;
    PortalView portal;
    /// for ray casting: all lights without a shape, those in `emitters` and those for it alone
    View<EmitterData> castLights;
};

}  // namespace glint
