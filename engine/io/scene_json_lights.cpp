// Glint JSON: lights without a shape, and the environment.
#include <fmt/format.h>

#include "engine/io/scene_json_keys.h"
#include "engine/io/scene_json_reader.h"

namespace glint {
namespace {

/// In the order of LightKind.
constexpr std::string_view kLightTypes[] = {"point", "spot", "directional"};

}  // namespace

void SceneJsonReader::readLights(const JsonValue& value) {
    if (!value.present() || !expectType(errors_, value, "lights", JsonType::Array)) { return; }
    forEachItem(errors_, value, [&](const JsonValue& item, size_t number) {
        Light light = readLight(item);
        if (light.name.empty()) { light.name = fmt::format("light {}", number + 1); }
        scene_.lights.push_back(std::move(light));
    });
}

Light SceneJsonReader::readLight(const JsonValue& value) {
    Light light;
    const int type = typeOf(value, "light", kLightTypes);
    if (type < 0) { return light; }
    light.kind = static_cast<LightKind>(type);
    const JsonFields fields = fieldsOf(value, kLightTypes[type], kLightTypes[type]);
    fields.string("name", &light.name);
    fields.color("color", kNotNegative, &light.color);
    if (light.kind == LightKind::Directional) {
        fields.direction("direction", &light.direction);
        fields.number("irradiance", kNotNegative, &light.strength);
        return light;
    }
    fields.require("position");
    fields.vec3("position", &light.position);
    fields.number("intensity", kNotNegative, &light.strength);
    if (light.kind == LightKind::Spot) {
        fields.direction("direction", &light.direction);
        fields.number("coneAngleDeg",
                      {.lo = 0.0f,
                       .hi = 90.0f,
                       .openLo = true,
                       .expected = "a half angle above 0 and up to 90 degrees"},
                      &light.coneAngleDeg);
        light.coneFalloffStartDeg = 0.75f * light.coneAngleDeg;
        fields.number(
            "coneFalloffStartDeg",
            {.lo = 0.0f, .hi = light.coneAngleDeg, .expected = "a half angle from 0 to \"coneAngleDeg\""},
            &light.coneFalloffStartDeg);
    }
    return light;
}

void SceneJsonReader::readEnvironment(const JsonValue& value) {
    if (!value.present()) { return; }
    const JsonFields fields = fieldsOf(value, "environment", "environment");
    Environment& environment = scene_.environment;
    environment.color = Vec3(1.0f);
    fields.color("color", kNotNegative, &environment.color);
    fields.number("strength", kNotNegative, &environment.strength);
    fields.number("rotationDeg", kAnyNumber, &environment.rotationDeg);
    if (const JsonValue image = fields.find("image"); image.present()) { readEnvironmentImage(image); }
}

void SceneJsonReader::readEnvironmentImage(const JsonValue& value) {
    if (errors_.failed() || !expectType(errors_, value, "image", JsonType::Object)) { return; }
    bool isSky = false;
    forEachMember(errors_, value,
                  [&](const std::string& key, const JsonValue&) { isSky |= key == "generator"; });
    SceneImage image;
    if (isSky) {
        image.source = readSky(fieldsOf(value, "sky", "sky"));
        if (errors_.failed()) { return; }
        environmentPlace_ = value;
    } else {
        const JsonFields fields = fieldsOf(value, "image", "environmentFile");
        const JsonValue file = fields.require("file");
        FileSource named;
        fields.string("file", &named.path);
        image.source = named;
        if (errors_.failed()) { return; }
        environmentPlace_ = file;
    }
    scene_.environment.image = static_cast<int>(scene_.environmentImages.size());
    scene_.environmentImages.push_back(std::move(image));
}

SkySource SceneJsonReader::readSky(const JsonFields& fields) {
    enum class Generator { Sky };
    constexpr std::pair<std::string_view, Generator> kGenerators[] = {{"sky", Generator::Sky}};
    Generator generator = Generator::Sky;
    SkySource sky;
    fields.choice("generator", kGenerators, &generator);
    fields.color("zenith", kNotNegative, &sky.zenith);
    fields.color("horizon", kNotNegative, &sky.horizon);
    fields.color("ground", kNotNegative, &sky.ground);
    fields.color("sun", kNotNegative, &sky.sun);
    fields.number("sunElevationDeg",
                  {.lo = -90.0f, .hi = 90.0f, .expected = "an angle from -90 to 90 degrees"},
                  &sky.sunElevationDeg);
    fields.number("sunAzimuthDeg", kAnyNumber, &sky.sunAzimuthDeg);
    fields.number("sunRadiusDeg", {.lo = 0.1f, .hi = 90.0f, .expected = "an angle from 0.1 to 90 degrees"},
                  &sky.sunRadiusDeg);
    fields.integer("width", 16, 8192, &sky.width);
    if (sky.width % 2 != 0) {
        errors_.add(fields.find("width"), "\"width\" is odd; expected an even number of pixels");
    }
    return sky;
}

}  // namespace glint
