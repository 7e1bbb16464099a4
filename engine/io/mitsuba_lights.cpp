#include "engine/io/mitsuba_lights.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/io/image_io.h"
#include "engine/io/mitsuba_environment.h"
#include "engine/io/mitsuba_sensor.h"
#include "engine/io/mitsuba_sky.h"
#include "engine/io/mitsuba_spectrum.h"
#include "engine/io/projected_image.h"
#include "engine/math/color.h"

namespace glint {
namespace {

Affine toWorldOf(MitsubaObject* object) { return object->context().world * object->transform(); }

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
    if (color && color->texture != nullptr && kind == LightKind::Projector) {
        light.image = textures_.color(*color->texture, UvOrigin::Bottom);
        if (light.image.texture < 0) { light.image.value = Vec3(0.5f); }
    } else if (color && color->texture != nullptr) {
        object->approximated("approximated: lights without a shape have no pictures");
    }
    context_.scene.lights.push_back(std::move(light));
    return &context_.scene.lights.back();
}

void MitsubaLights::placePoint(MitsubaObject* object) {
    Light* light = add(object, LightKind::Point, {"intensity"});
    light->position = toWorldOf(object).point(object->vector("position", Vec3(0.0f)));
}

void MitsubaLights::placeSpot(MitsubaObject* object) {
    Light* light = add(object, LightKind::Spot, {"intensity"});
    const Affine toWorld = toWorldOf(object);
    light->position = toWorld.translation;
    light->direction = toWorld.vector(Vec3(0, 0, 1));
    light->coneAngleDeg = object->number("cutoff_angle", 20.0f, 0.01f, 90.0f);
    light->coneFalloffStartDeg =
        std::min(object->number("beam_width", 0.75f * light->coneAngleDeg, 0.0f, 90.0f), light->coneAngleDeg);
    if (light->coneFalloffStartDeg < light->coneAngleDeg) {
        object->approximated("approximated: spots fall off smoothly between their angles, not linearly");
    }
}

/// Of an image; all else is square.
float MitsubaLights::aspectOf(const ColorInput& image) {
    if (image.texture < 0) { return 1.0f; }
    const ImageSource& source = context_.scene.textures[static_cast<size_t>(image.texture)].image.source;
    if (std::holds_alternative<Checkerboard>(source)) { return 1.0f; }
    const Result<SceneImage> read = assets_.texture(source);
    if (!read) { return 1.0f; }
    const Vec2 size = read->floats ? Vec2(read->floats->width, read->floats->height)
                                   : Vec2(read->bytes->width, read->bytes->height);
    return size.x / size.y;
}

/// Its camera's x points to the left. What Mitsuba calls irradiance is what a white surface reflects, pi
/// times less.
void MitsubaLights::placeProjector(MitsubaObject* object) {
    Light* light = add(object, LightKind::Projector, {"irradiance"});
    light->strength = kPi * object->number("scale", 1.0f, 0.0f);
    light->aspect = aspectOf(light->image);
    const float vertical = mitsubaVerticalFov(object, light->aspect);
    const float half = light->aspect * std::tan(0.5f * vertical / kDegreesPerRadian);
    light->fovDeg = std::clamp(2.0f * std::atan(half) * kDegreesPerRadian, 0.01f, 179.9f);
    if (!aimProjector(toWorldOf(object), Vec3(-1, 0, 0), light, &context_.scene)) {
        context_.fail(object->element(), "the light is flattened");
    }
}

void MitsubaLights::placeDirectional(MitsubaObject* object) {
    Light* light = add(object, LightKind::Directional, {"irradiance"});
    light->direction = toWorldOf(object).vector(object->vector("direction", Vec3(0, 0, 1)));
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
    const Affine toWorld = toWorldOf(object);
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
    const std::shared_ptr<const ImageF> pixels = linearColors(*read);
    if (turnDeg && pixels->height > kMostRows) {
        context_.note(object->element(), "the rows of a large environment lie up to half a row off");
        return image;
    }
    const ImageF laidOut = turnDeg ? withCentredRows(*pixels) : turnedMap(*pixels, toWorld, hasRowsAtPoles);
    image.source = bakedImage(laidOut, path, 0);
    return image;
}

void MitsubaLights::placeSky(MitsubaObject* object) {
    object->approximated("approximated: skies are Preetham's");
    const bool isZUp = context_.xml.majorVersion() >= 2;
    const Affine toWorld = toWorldOf(object);
    SunTime time;
    time.year = object->integer("year", time.year, 0, 9999);
    time.month = object->integer("month", time.month, 1, 12);
    time.day = object->integer("day", time.day, 1, 31);
    time.hour = static_cast<double>(object->number("hour", 15.0f, 0.0f, 24.0f) +
                                    object->number("minute", 0.0f, 0.0f, 60.0f) / 60.0f);
    time.latitudeDeg = static_cast<double>(object->number("latitude", 35.6894f, -90.0f, 90.0f));
    time.longitudeDeg = static_cast<double>(object->number("longitude", 139.6917f, -180.0f, 180.0f));
    time.timezone = static_cast<double>(object->number("timezone", 9.0f, -14.0f, 14.0f));
    // To directions with y up.
    const Mat3 upright = isZUp ? Mat3(1, 0, 0, 0, 0, -1, 0, 1, 0) : Mat3(1.0f);
    const bool isGiven = object->property("sun_direction") != nullptr;
    const Vec3 given = object->vector("sun_direction", Vec3(0, 1, 0));
    const Vec3 sun = isGiven && !isZero(given) ? upright * given : sunDirection(time);
    const PreethamSky sky(sun, object->number("turbidity", 3.0f));
    const float scale = object->number("scale", 1.0f, 0.0f, 1e9f);
    const float skyScale = scale * object->number("sky_scale", 1.0f, 0.0f, 1e9f);
    const float sunScale = scale * object->number("sun_scale", 1.0f, 0.0f, 1e9f);
    const float radiusDeg = 0.2679f * object->number("sun_radius_scale", 1.0f, 0.0f, 100.0f);
    object->passOver({"albedo", "stretch", "resolution", "sun_aperture", "complex_sun", "extend", "second"});
    if (context_.failed() || !isInvertible(toWorld)) { return; }
    if (object->type() == "sun") {
        Light* light = add(object, LightKind::Directional, {});
        light->color = sunScale * sky.sunIrradiance();
        light->direction = toWorld.vector(glm::transpose(upright) * -sky.sun());
        return;
    }
    if (!takesEnvironment(object)) { return; }
    constexpr int kWidth = 1024;
    const Vec3 sunlight = object->type() == "sky" ? Vec3(0.0f) : sunScale * sky.sunIrradiance();
    const ImageF map = skyMap(sky, upright * inverse(toWorld).linear, skyScale, sunlight, radiusDeg, kWidth);
    context_.scene.environment = {.color = Vec3(1.0f)};
    context_.scene.environment.image = static_cast<int>(context_.scene.environmentImages.size());
    context_.scene.environmentImages.push_back(
        {.source = bakedImage(map, "sky", context_.scene.environmentImages.size())});
}

}  // namespace glint
