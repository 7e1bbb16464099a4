#include "engine/io/mitsuba_shapes.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/scene/scene_use.h"

namespace glint {
namespace {

constexpr size_t kMaxObjects = 4'000'000;

/// The flat shapes' front, turned over about x.
const Affine kTurnedOver{Mat3(1, 0, 0, 0, -1, 0, 0, 0, -1), Vec3(0.0f)};

/// Two unit vectors that make a right-handed frame with n: Duff et al. 2017, "Building an Orthonormal
/// Basis, Revisited".
Mat3 frameOf(const Vec3& n) {
    const float sign = std::copysign(1.0f, n.z), a = -1.0f / (sign + n.z), b = n.x * n.y * a;
    return {Vec3(1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x), Vec3(b, sign + n.y * n.y * a, -n.y), n};
}

UvOrigin meshOrigin(MitsubaObject* object) {
    const bool isObj = object->type() == "obj";
    // Glint counts v of OBJ files upwards as they do, which is what Mitsuba turns over by default.
    return object->flag("flip_tex_coords", isObj) ? UvOrigin::Bottom : UvOrigin::Top;
}

}  // namespace

void MitsubaShapes::place(const MitsubaElement& shape) {
    std::vector<Object> objects = objectsOf(shape);
    if (context_.scene.objects.size() + objects.size() > kMaxObjects) {
        context_.fail(shape, fmt::format("its shapes place more than {} objects", kMaxObjects));
        return;
    }
    if (!(context_.world == Affine())) {
        for (Object& object : objects) {
            object.objectToWorld = context_.world * object.objectToWorld;
        }
    }
    context_.scene.objects.insert(context_.scene.objects.end(), std::make_move_iterator(objects.begin()),
                                  std::make_move_iterator(objects.end()));
}

std::vector<Object> MitsubaShapes::objectsOf(const MitsubaElement& element) {
    MitsubaObject object(&context_, element);
    if (context_.failed()) { return {}; }
    const std::string_view type = object.type();
    if (type == "shapegroup") {
        groups_[&element] = groupOf(&object);
        return {};
    }
    if (type == "instance") { return instancesOf(&object); }
    if (type == "merge") { return groupOf(&object); }
    Shape shape{&object, object.next({"bsdf"}),      object.next({"emitter"}), object.transform(),
                false,   object.property("interior")};
    if (shape.interior != nullptr && !isGlassBody(shape.bsdf)) {
        context_.remark(element, "media are left out");
        shape.interior = nullptr;
    }
    std::vector<Object> out;
    if (type == "obj" || type == "ply" || type == "serialized") {
        out = meshOf(&shape);
    } else {
        shape.isFlipped = object.flag("flip_normals", false);
        if (type == "cube") {
            out = cubeOf(shape);
        } else if (type == "sphere") {
            out = sphereOf(shape);
        } else if (type == "rectangle" || type == "disk") {
            out = flatOf(shape, type == "disk" ? ShapeKind::Disc : ShapeKind::Rectangle);
        } else if (type == "cylinder") {
            out = cylinderOf(shape);
        } else {
            context_.refuse(element, fmt::format("Glint has no shape \"{}\"", type));
            return {};
        }
    }
    if (object.next({"medium"}) != nullptr) {
        context_.remark(element, "media are left out");
        object.next({"medium"});
    }
    object.finish();
    return out;
}

std::vector<Object> MitsubaShapes::groupOf(MitsubaObject* object) {
    std::vector<Object> objects;
    while (const MitsubaElement* shape = object->next({"shape"})) {
        for (Object& part : objectsOf(*shape)) {
            objects.push_back(std::move(part));
        }
    }
    object->finish();
    return objects;
}

std::vector<Object> MitsubaShapes::instancesOf(MitsubaObject* object) {
    const MitsubaElement* group = object->next({"shape"});
    const Affine toWorld = object->transform();
    object->finish();
    if (group == nullptr || group->attribute("type") != "shapegroup") {
        context_.fail(object->element(), "the instance names no shapegroup");
        return {};
    }
    if (!groups_.contains(group)) { objectsOf(*group); }
    std::vector<Object> objects = groups_[group];
    for (Object& part : objects) {
        part.objectToWorld = toWorld * part.objectToWorld;
    }
    std::erase_if(objects, [&](const Object& part) {
        const bool isFlat = !isInvertible(part.objectToWorld);
        if (isFlat) { context_.remark(object->element(), "shapes that are flattened are left out"); }
        return isFlat;
    });
    return objects;
}

bool MitsubaShapes::looksAtUv(const MitsubaElement* bsdf) {
    const Material material = materials_.surfaceOf(bsdf, UvOrigin::Top).material;
    return isAnisotropic(material) || !usedTextures(material).empty();
}

/// Per metre.
Vec3 MitsubaShapes::absorptionOf(const MitsubaElement& element) {
    MitsubaObject medium(&context_, element);
    if (medium.type() != "homogeneous") {
        context_.remark(element, "media are left out");
        return Vec3(0.0f);
    }
    const auto color = [&](std::string_view name, float otherwise) {
        const auto input = mitsubaInput(&medium, {name}, SpectrumRole::Index);
        return input && input->texture == nullptr ? input->color : Vec3(otherwise);
    };
    const bool isApart = medium.property("sigma_a") != nullptr || medium.property("sigma_s") != nullptr;
    const Vec3 first = color(isApart ? "sigma_a" : "sigma_t", isApart ? 0.0f : 1.0f);
    const Vec3 second = color(isApart ? "sigma_s" : "albedo", isApart ? 0.0f : 0.75f);
    if (!isZero(second)) { medium.approximated("approximated: media absorb, but scatter nothing"); }
    medium.passOver({"sample_emitters", "has_spectral_extinction"});
    const float scale = medium.number("scale", 1.0f, 0.0f);
    medium.finish();
    return glm::max(scale * (isApart ? first : first * (Vec3(1.0f) - second)), Vec3(0.0f));
}

bool MitsubaShapes::isGlassBody(const MitsubaElement* bsdf) {
    const MitsubaSurface& surface = materials_.surfaceOf(bsdf, UvOrigin::Top);
    return surface.isThere && isClearBody(surface.material);
}

int MitsubaShapes::glassOf(const Shape& shape, UvOrigin origin) {
    MitsubaSurface surface = materials_.surfaceOf(shape.bsdf, origin);
    const auto [known, isNew] = glasses_.try_emplace({shape.bsdf, shape.interior, origin}, 0);
    if (!isNew) { return known->second; }
    const Vec3 absorption = absorptionOf(*shape.interior);
    const float most = maxComponent(absorption);
    if (most > 0.0f) {
        surface.material.attenuationDistance = 1.0f / most;
        surface.material.attenuationColor = glm::exp(-absorption / most);
    }
    return known->second = materials_.add(surface, {Vec3(0.0f)}, false);
}

int MitsubaShapes::materialOf(const Shape& shape, UvOrigin origin) {
    if (shape.emitter == nullptr) {
        return shape.interior != nullptr ? glassOf(shape, origin) : materials_.take(shape.bsdf, origin);
    }
    MitsubaObject emitter(&context_, *shape.emitter);
    if (emitter.type() != "area") {
        context_.refuse(*shape.emitter,
                        fmt::format("Glint has no emitter \"{}\" on a shape", emitter.type()));
        return materials_.take(shape.bsdf, origin);
    }
    const auto radiance = mitsubaInput(&emitter, {"radiance", "intensity"}, SpectrumRole::Emission);
    emitter.passOver({"sampling_weight", "samples"});
    emitter.finish();
    const ColorInput emission = !radiance ? ColorInput{Vec3(1.0f)}
                                : radiance->texture != nullptr
                                    ? materials_.emissionOf(*radiance->texture, origin)
                                    : ColorInput{radiance->color};
    return materials_.add(materials_.surfaceOf(shape.bsdf, origin), emission, false);
}

std::vector<Object> MitsubaShapes::finish(const Shape& shape, Object object, UvOrigin origin, int meshBack) {
    const MitsubaSurface& surface = materials_.surfaceOf(shape.bsdf, origin);
    if (context_.failed()) { return {}; }
    const bool shines = shape.emitter != nullptr;
    if (!surface.isThere && !shines) { return {}; }
    if (!isInvertible(object.objectToWorld)) {
        context_.remark(shape.object->element(), "shapes that are flattened are left out");
        return {};
    }
    const std::string_view id = shape.object->element().attribute("id");
    object.name = id.empty() ? shape.object->type() : id;
    if (surface.isThere) {
        object.material = materialOf(shape, origin);
    } else {
        shape.object->approximated("approximated: what shines and is not there is black");
        object.material = materialOf({shape.object, nullptr, shape.emitter, {}, false, nullptr}, origin);
        context_.scene.materials[static_cast<size_t>(object.material)].color.value = Vec3(0.0f);
    }
    const bool hasBack =
        object.shape == ShapeKind::Rectangle || object.shape == ShapeKind::Disc || meshBack >= 0;
    if ((surface.isTwoSided && surface.back == nullptr) || !hasBack) { return {std::move(object)}; }
    Object back = object;
    back.name += " from behind";
    back.material =
        surface.back != nullptr ? materials_.take(surface.back, origin) : materials_.black(surface);
    if (meshBack >= 0) {
        back.mesh = meshBack;
    } else {
        back.objectToWorld = object.objectToWorld * kTurnedOver;
    }
    object.frontOnly = back.frontOnly = true;
    if (surface.back != nullptr) {
        if (meshBack < 0 && looksAtUv(surface.back)) {
            shape.object->approximated("approximated: textures on backs of flat shapes lie mirrored");
        }
        return {std::move(object), std::move(back)};
    }
    context_.note(shape.object->element(),
                  "surfaces that are not \"twosided\" are black from behind: each is two objects");
    return {std::move(object), std::move(back)};
}

std::vector<Object> MitsubaShapes::meshOf(Shape* shape) {
    const UvOrigin origin = meshOrigin(shape->object);
    const MitsubaSurface& surface = materials_.surfaceOf(shape->bsdf, origin);
    if (context_.failed()) { return {}; }
    const MitsubaMesh mesh = meshes_.take(shape->object, surface, shape->toWorld.determinant() < 0.0f);
    if (mesh.index < 0) { return {}; }
    Object object;
    object.shape = ShapeKind::Mesh;
    object.mesh = mesh.index;
    object.objectToWorld = shape->toWorld;
    const bool needsBack = mesh.isOpen && (!surface.isTwoSided || surface.back != nullptr);
    return finish(*shape, std::move(object), origin, needsBack ? meshes_.reversed(mesh.index) : -1);
}

std::vector<Object> MitsubaShapes::cubeOf(const Shape& shape) {
    Object object;
    object.shape = ShapeKind::Mesh;
    object.mesh = meshes_.cube(shape.isFlipped).index;
    object.objectToWorld = shape.toWorld;
    return finish(shape, std::move(object), UvOrigin::Top, -1);
}

std::vector<Object> MitsubaShapes::sphereOf(const Shape& shape) {
    Object object;
    object.shape = ShapeKind::Sphere;
    const Vec3 center = shape.object->vector("center", Vec3(0.0f));
    const float radius = shape.object->number("radius", 1.0f, 0.0f);
    object.objectToWorld = shape.toWorld * translate(center) * scale(Vec3(radius));
    if (looksAtUv(shape.bsdf)) {  // Mitsuba's north is +z, and its u begins at +x
        object.objectToWorld = object.objectToWorld * Affine{Mat3(0, -1, 0, 0, 0, 1, -1, 0, 0), Vec3(0.0f)};
    }
    if (shape.isFlipped) {
        shape.object->approximated("approximated: spheres and cylinders are not turned inside out");
    }
    return finish(shape, std::move(object), UvOrigin::Bottom, -1);
}

std::vector<Object> MitsubaShapes::flatOf(const Shape& shape, ShapeKind kind) {
    Object object;
    object.shape = kind;
    object.objectToWorld = shape.isFlipped ? shape.toWorld * kTurnedOver : shape.toWorld;
    if (kind == ShapeKind::Disc && looksAtUv(shape.bsdf)) {
        shape.object->approximated(
            "approximated: textures and anisotropy lie flat on disks, not around their middles");
    }
    return finish(shape, std::move(object), shape.isFlipped ? UvOrigin::Bottom : UvOrigin::Top, -1);
}

std::vector<Object> MitsubaShapes::cylinderOf(const Shape& shape) {
    const Vec3 p0 = shape.object->vector("p0", Vec3(0.0f)), p1 = shape.object->vector("p1", Vec3(0, 0, 1));
    const float radius = shape.object->number("radius", 1.0f, 0.0f), length = glm::length(p1 - p0);
    if (!(radius > 0.0f && length > 0.0f)) {
        context_.remark(shape.object->element(), "shapes that are flattened are left out");
        return {};
    }
    Object object;
    object.shape = ShapeKind::Revolved;
    object.curve = CurveKind::Bezier;
    object.curveDegree = 1;
    object.profile = {{radius, 0.0f}, {radius, length}};
    const Mat3 frame = frameOf((p1 - p0) / length);
    object.objectToWorld = shape.toWorld * Affine{Mat3(frame[0], frame[2], -frame[1]), p0};  // its axis is y
    if (shape.isFlipped) {
        shape.object->approximated("approximated: spheres and cylinders are not turned inside out");
    }
    if (!materials_.surfaceOf(shape.bsdf, UvOrigin::Bottom).isTwoSided) {
        shape.object->approximated("approximated: cylinders that are not \"twosided\" reflect inside, too");
    }
    return finish(shape, std::move(object), UvOrigin::Bottom, -1);
}

}  // namespace glint
