#include "engine/builders/point_emitters.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/builders/emission_means.h"
#include "engine/kernels/shapes/shapes.h"
#include "engine/math/color.h"

namespace glint {
namespace {

/// 1 - cos as 2 sin^2 of the half: keeps its digits for narrow angles.
float oneMinusCosine(float angleDeg) {
    const double sine = std::sin(static_cast<double>(angleDeg) * (std::numbers::pi / 360.0));
    return static_cast<float>(2.0 * sine * sine);
}

/// The direction is set.
void setImage(const Light& light, const TextureTable& textures, EmitterData* e) {
    e->original = textures.packed(light.image.texture);
    e->axisU = imageRight(light);
    e->axisV = glm::cross(e->axisU, e->direction);
    const bool isImage = e->original != kNone;
    if (!isImage) { e->radiance *= light.image.value; }
    e->area = isImage ? luminance(EmissionMeans(textures.textures[e->original]).overAll()) : 1.0f;
}

}  // namespace

EmitterData pointlikeEmitter(const Light& light, const TextureTable& textures) {
    EmitterData e;
    e.position = light.position;
    e.radiance = light.color * light.strength;
    const float length = glm::length(light.direction);
    e.direction = length > 0.0f ? light.direction / length : Vec3(0, -1, 0);
    switch (light.kind) {
        case LightKind::Point:
            e.kind = EmitterKind::Point;
            break;
        case LightKind::Spot:
            e.kind = EmitterKind::Spot;
            break;
        case LightKind::Directional:
            e.kind = EmitterKind::Directional;
            break;
        case LightKind::Projector: {
            e.kind = EmitterKind::Projector;
            setImage(light, textures, &e);
            const float half = std::tan(0.5f * light.fovDeg * (kPi / 180.0f));
            e.axisU *= half;
            e.axisV *= half / light.aspect;
            break;
        }
        case LightKind::Goniometric:
            e.kind = EmitterKind::Goniometric;
            setImage(light, textures, &e);
            break;
    }
    e.oneMinusCosOuter = oneMinusCosine(light.coneAngleDeg);
    e.oneMinusCosInner = oneMinusCosine(std::min(light.coneFalloffStartDeg, light.coneAngleDeg));
    if (e.kind == EmitterKind::Directional) { e.area = luminance(e.radiance); }
    return e;
}

LightNode leafNode(const EmitterData& e) {
    LightNode node;
    node.center = e.position;
    node.intensity = luminance(e.radiance);
    node.bothSides = e.emitsBothSides;
    switch (e.kind) {
        case EmitterKind::Shape:
            visitShape<void, kAllFeatures>(e.shape,
                                           [&](auto shape) { decltype(shape)::boundEmitter(e, &node); });
            break;
        case EmitterKind::Spot:
            node.axis = e.direction;
            node.cosNormals = 1.0f - e.oneMinusCosOuter;
            node.cosEmission = 0.999f;
            break;
        case EmitterKind::Projector: {
            const float most = lengthSquared(e.axisU) + lengthSquared(e.axisV);  // tan^2 to the corners
            node.axis = e.direction;
            node.cosNormals = 1.0f / std::sqrt(1.0f + most);
            node.cosEmission = 0.999f;
            node.intensity *= e.area * std::pow(1.0f + most, 1.5f);
            break;
        }
        case EmitterKind::Goniometric:
            node.intensity *= e.area;
            break;
        case EmitterKind::Point:
        case EmitterKind::Directional:
        case EmitterKind::Environment:
            break;
    }
    node.radius *= 1.0f + 1e-6f;
    if (!std::isfinite(node.intensity)) { node.intensity = 1e30f; }
    return node;
}

}  // namespace glint
