#include "engine/io/projected_image.h"

#include <cmath>

#include "engine/io/image_io.h"

namespace glint {
namespace {

/// Shows at 1 - u what it showed at u.
void mirror(Texture* texture) {
    const float angle = texture->rotationDeg / kDegreesPerRadian, width = texture->scale.x;
    texture->offset += width * Vec2(std::cos(angle), std::sin(angle));
    texture->scale.x = -width;
}

Vec3 meanOf(const SceneDescription& scene, const ColorInput& image) {
    if (image.texture < 0) { return image.value; }
    const Texture& texture = scene.textures[static_cast<size_t>(image.texture)];
    const auto pixels = texture.image.isRead() ? linearColors(texture.image) : nullptr;
    if (!pixels || pixels->rgb.empty()) { return image.value; }
    glm::dvec3 sum(0.0);
    for (size_t i = 0; i + 2 < pixels->rgb.size(); i += 3) {
        sum += glm::dvec3(pixels->rgb[i], pixels->rgb[i + 1], pixels->rgb[i + 2]);
    }
    return Vec3(sum / (static_cast<double>(pixels->rgb.size()) / 3.0));
}

}  // namespace

bool aimProjector(const Affine& toWorld, const Vec3& right, Light* light, SceneDescription* scene) {
    if (!isInvertible(toWorld)) { return false; }
    light->position = toWorld.translation;
    light->direction = toWorld.vector(Vec3(0, 0, 1));
    light->up = toWorld.vector(Vec3(0, 1, 0));
    const bool isMirrored = glm::dot(toWorld.vector(right), glm::cross(light->direction, light->up)) < 0.0f;
    if (isMirrored && light->image.texture >= 0) {
        Texture texture = scene->textures[static_cast<size_t>(light->image.texture)];
        mirror(&texture);
        light->image.texture = static_cast<int>(scene->textures.size());
        scene->textures.push_back(std::move(texture));
    }
    return true;
}

Vec2 projectedExtent(const Light& projector) {
    const float half = std::tan(0.5f * projector.fovDeg / kDegreesPerRadian);
    return {half, half / projector.aspect};
}

std::string_view lostImage(LightKind kind) {
    return kind == LightKind::Projector
               ? "approximated: projectors are spots of the same power, without a picture"
               : "approximated: goniometric lights shine alike in all directions";
}

float aspectOf(const SceneImage& image) {
    if (image.floats) {
        return static_cast<float>(image.floats->width) / static_cast<float>(image.floats->height);
    }
    const bool isImage = image.bytes && !std::holds_alternative<Checkerboard>(image.source);
    return isImage ? static_cast<float>(image.bytes->width) / static_cast<float>(image.bytes->height) : 1.0f;
}

Light withoutImage(const SceneDescription& scene, const Light& projector) {
    Light spot = projector;
    if (projector.kind == LightKind::Goniometric) {
        spot.kind = LightKind::Point;
        spot.color *= meanOf(scene, projector.image);
        return spot;
    }
    spot.kind = LightKind::Spot;
    const Vec2 half = projectedExtent(projector);
    const float area = 4.0f * half.x * half.y;
    const float cone = std::atan(std::sqrt(area / kPi));
    spot.color = projector.color * meanOf(scene, projector.image);
    spot.strength = projector.strength * area / (kTwoPi * (1.0f - std::cos(cone)));
    spot.coneAngleDeg = spot.coneFalloffStartDeg = cone * kDegreesPerRadian;
    return spot;
}

}  // namespace glint
