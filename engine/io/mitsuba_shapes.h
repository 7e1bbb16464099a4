// Mitsuba's shapes as objects. Internal to the Mitsuba importer.
#pragma once

#include <map>
#include <tuple>
#include <vector>

#include "engine/io/mitsuba_materials.h"
#include "engine/io/mitsuba_meshes.h"

namespace glint {

class MitsubaShapes {
  public:
    MitsubaShapes(MitsubaContext* context, MitsubaMaterials* materials, MitsubaMeshes* meshes)
        : context_(*context), materials_(*materials), meshes_(*meshes) {}

    /// Appends the objects of a shape; none of a shapegroup, which instances place.
    void place(const MitsubaElement& shape);

  private:
    /// A shape in the making.
    struct Shape {
        MitsubaObject* object;
        const MitsubaElement* bsdf;
        const MitsubaElement* emitter;
        Affine toWorld;
        bool isFlipped;
        const MitsubaElement* interior;  ///< a medium; null: none
    };

    std::vector<Object> objectsOf(const MitsubaElement& shape);
    std::vector<Object> instancesOf(MitsubaObject* object);
    std::vector<Object> groupOf(MitsubaObject* object);
    std::vector<Object> finish(const Shape& shape, Object object, UvOrigin origin, int meshBack);
    std::vector<Object> meshOf(Shape* shape);
    std::vector<Object> cubeOf(const Shape& shape);
    std::vector<Object> sphereOf(const Shape& shape);
    std::vector<Object> flatOf(const Shape& shape, ShapeKind kind);
    std::vector<Object> cylinderOf(const Shape& shape);
    bool looksAtUv(const MitsubaElement* bsdf);
    int materialOf(const Shape& shape, UvOrigin origin);
    bool isGlassBody(const MitsubaElement* bsdf);
    /// Of a glass body, whose inside absorbs: a material of its own.
    int glassOf(const Shape& shape, UvOrigin origin);
    Vec3 absorptionOf(const MitsubaElement& medium);

    MitsubaContext& context_;
    MitsubaMaterials& materials_;
    MitsubaMeshes& meshes_;
    std::map<const MitsubaElement*, std::vector<Object>> groups_;
    std::map<std::tuple<const MitsubaElement*, const MitsubaElement*, UvOrigin>, int> glasses_;
};

}  // namespace glint
