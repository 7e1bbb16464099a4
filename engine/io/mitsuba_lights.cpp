#include "engine/io/mitsuba_lights.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/io/image_io.h"
#include "engine/io/mitsuba_environment.h"
#include "engine/io/mitsuba_spectrum.h"
#include "engine/math/color.h"

namespace glint {
namespace {

constexpr float kDegrees = 180.0f / kPi;

}  // namespace

void MitsubaLights::place(const MitsubaElement& emitter) {
    struct Kind {
        std::string_view name;
        void (MitsubaLights::*place)(MitsubaObject*);
    };
    static constexpr Kind kKinds[] = {{"point", &MitsubaLights::placePoint},
                                      {"spot", &MitsubaLights::placeSpot},
                                      {"projector", &MitsubaLights::placeProjector},
                                      {"directional", &MitsubaLights::placeDirectional},
                                      {"constant", &MitsubaLights::placeConstant},
                                      {"envmap", &MitsubaLights::placeMap},
                                      {"sky", &MitsubaLights::placeSky},
                                      {"sun", &MitsubaLights::placeSky},
                                      {"sunsky", &MitsubaLights::placeSky}};
    MitsubaObject object(&context_, emitter);
    const auto kind = std::ranges::find(kKinds, object.type(), &Kind::name);
    if (kind == std::end(kKinds)) {
        context_.refuse(emitter, fmt::format("Glint has no emitter \"{}\"", object.type()));
        return;
    }
    object.passOver({"sampling_weight", "samples", "shutter_open"});
    (this->*kind->place)(&object);
    object.finish();
}

Light* MitsubaLights::add(MitsubaObject* object, LightKind kind,
                          std::initializer_list<std::string_view> radiometry) {
    Light light;
    const std::string_view id = object->element().attribute("id");
    light.name = id.empty() ? object->type() : id;
    light.kind = kind;
    const auto color = mitsubaInput(object, radiometry, SpectrumRole::Emission);
    light.color = color && color->texture == nullptr ? color->color : Vec3(1.0f);
    if (color && color->texture != nullptr) {
        object->approximated("approximated: lights without a shape have no pictures");
    }
    context_.scene.lights.push_back(std::move(light));
    return &context_.scene.lights.back();
}

void MitsubaLights::placePoint(MitsubaObject* object) {
    Light* light = add(object, LightKind::Point, {"intensity"});
    light->position = object->transform().point(object->vector("position", Vec3(0.0f)));
}

void MitsubaLights::placeSpot(MitsubaObject* object) {
    Light* light = add(object, LightKind::Spot, {"intensity"});
    const Affine toWorld = object->transform();
    light->position = toWorld.translation;
    light->direction = toWorld.vector(Vec3(0, 0, 1));
    light->coneAngleDeg = object->number("cutoff_angle", 20.0f, 0.01f, 90.0f);
    light->coneFalloffStartDeg =
        std::min(object->number("beam_width", 0.75f * light->coneAngleDeg, 0.0f, 90.0f), light->coneAngleDeg);
    if (light->coneFalloffStartDeg < light->coneAngleDeg) {
        object->approximated("approximated: spots fall off smoothly between their angles, not linearly");
    }
}

/// Its power is pi irradiance times the image's area at a distance of 1; the spot has that, over as much of
/// the plane there.
void MitsubaLights::placeProjector(MitsubaObject* object) {
    object->approximated("approximated: projectors are spots of the same power, without a picture");
    Light* light = add(object, LightKind::Spot, {"irradiance"});
    const Affine toWorld = object->transform();
    light->position = toWorld.translation;
    light->direction = toWorld.vector(Vec3(0, 0, 1));
    const float side = 2.0f * std::tan(0.5f * object->number("fov", 40.0f, 0.1f, 179.0f) / kDegrees);
    const float cone = std::atan(side / std::sqrt(kPi));
    light->strength = object->number("scale", 1.0f, 0.0f) * square(side) / (2.0f * (1.0f - std::cos(cone)));
    light->coneAngleDeg = light->coneFalloffStartDeg = cone * kDegrees;
    object->passOver({"fov_axis", "focal_length"});
}

void MitsubaLights::placeDirectional(MitsubaObject* object) {
    Light* light = add(object, LightKind::Directional, {"irradiance"});
    light->direction = object->transform().vector(object->vector("direction", Vec3(0, 0, 1)));
    if (isZero(light->direction)) { context_.fail(object->element(), "the light has no direction"); }
}

bool MitsubaLights::takesEnvironment(MitsubaObject* object) {
    const bool isFirst = !context_.scene.environment.emissive();
    if (!isFirst) { context_.remark(object->element(), "environments after the first are left out"); }
    return isFirst;
}

void MitsubaLights::placeConstant(MitsubaObject* object) {
    const auto radiance = mitsubaInput(object, {"radiance", "intensity"}, SpectrumRole::Emission);
    if (takesEnvironment(object)) {
        context_.scene.environment.color = radiance ? radiance->color : Vec3(1.0f);
    }
}

void MitsubaLights::placeMap(MitsubaObject* object) {
    const float scale = object->number("scale", 1.0f, 0.0f);
    const Affine toWorld = object->transform();
    object->passOver({"mis_compensation", "cache"});
    const MitsubaElement* file = object->property("filename");
    if (file == nullptr) {
        context_.fail(object->element(), "the environment has no \"filename\"");
        return;
    }
    if (!takesEnvironment(object)) { return; }
    const std::string path = context_.fileOf(*file, file->attribute("value"));
    Environment& environment = context_.scene.environment;
    environment.color = Vec3(1.0f);
    environment.strength = scale;
    environment.image = static_cast<int>(context_.scene.environmentImages.size());
    context_.scene.environmentImages.push_back(imageOf(object, path, toWorld));
}

SceneImage MitsubaLights::imageOf(MitsubaObject* object, const std::string& path, const Affine& toWorld) {
    constexpr int kMostRows = 512;  // of an image that is laid out anew, whose rows are then as good as exact
    Environment& environment = context_.scene.environment;
    const std::optional<float> turnDeg = turnAboutY(toWorld);
    environment.rotationDeg = turnDeg.value_or(0.0f) + (turnDeg ? 180.0f : 0.0f);
    const bool hasRowsAtPoles = context_.xml.majorVersion() >= 2;
    SceneImage image{.source = FileSource{path}};
    if (turnDeg && !hasRowsAtPoles) { return image; }
    std::vector<std::string> warnings;
    const Result<SceneImage> read = assets_.environment(image.source, &warnings);
    if (!read) {
        context_.refuse(object->element(),
                        fmt::format("the environment \"{}\" cannot be read: {}", path, read.error().message));
        environment.image = -1;
        return image;
    }
    if (turnDeg && read->floats->height > kMostRows) {
        context_.note(object->element(), "the rows of a large environment lie up to half a row off");
        return image;
    }
    const ImageF laidOut =
        turnDeg ? withCentredRows(*read->floats) : turnedMap(*read->floats, toWorld, hasRowsAtPoles);
    image.source = bakedImage(laidOut, path, 0);
    return image;
}

void MitsubaLights::placeSky(MitsubaObject* object) {
    object->approximated("approximated: the sky is Glint's own, with the sun where it is");
    const Affine toWorld = object->transform();
    Vec3 sun = object->vector("sun_direction", Vec3(0.0f, 0.4f, 1.0f));
    sun = toWorld.vector(sun);
    const float scale = object->number("scale", 1.0f, 0.0f) * object->number("sky_scale", 1.0f, 0.0f);
    object->passOver({"turbidity", "albedo", "sun_scale", "stretch", "resolution", "sun_radius_scale",
                      "sun_aperture", "complex_sun", "extend", "year", "month", "day", "hour", "minute",
                      "second", "latitude", "longitude", "timezone"});
    if (!takesEnvironment(object)) { return; }
    SkySource sky;
    const float level = std::sqrt(sun.x * sun.x + sun.z * sun.z);
    sky.sunElevationDeg = std::atan2(sun.y, level) * kDegrees;
    sky.sunAzimuthDeg = std::atan2(-sun.z, sun.x) * kDegrees;
    if (object->type() == "sky") { sky.sun = Vec3(0.0f); }
    if (object->type() == "sun") { sky.zenith = sky.horizon = sky.ground = Vec3(0.0f); }
    context_.scene.environment = {.color = Vec3(1.0f), .strength = scale, .image = 0};
    context_.scene.environment.image = static_cast<int>(context_.scene.environmentImages.size());
    context_.scene.environmentImages.push_back({.source = sky});
}

}  // namespace glint
