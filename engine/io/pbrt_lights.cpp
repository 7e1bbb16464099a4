#include "engine/io/pbrt_lights.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/io/baked_image.h"
#include "engine/io/image_io.h"
#include "engine/io/pbrt_environment.h"
#include "engine/io/projected_image.h"
#include "engine/math/color.h"

namespace glint {
Vec3 PbrtLights::colorOf(const PbrtParams& params, std::string_view name) {
    const PbrtParam* param = params.find(name);
    if (param != nullptr) { return pbrtColor(params, *param, SpectrumRole::Emission); }
    return rgbOfSpace(params.colorSpace(), Vec3(1.0f), SpectrumRole::Emission);
}

void PbrtLights::place(const std::string& kind, const PbrtParams& params, const PbrtState& state) {
    const Affine toWorld = context_.world * affineOf(&context_, params.place(), state.transform);
    if (context_.failed()) { return; }
    if (!isInvertible(toWorld)) {
        params.approximated("lights that are flattened are left out");
        return;
    }
    struct Kind {
        std::string_view name;
        void (PbrtLights::*place)(const PbrtParams&, const Affine&);
    };
    static constexpr Kind kKinds[] = {
        {"point", &PbrtLights::placePoint},           {"spot", &PbrtLights::placeSpot},
        {"distant", &PbrtLights::placeDistant},       {"goniometric", &PbrtLights::placeGoniometric},
        {"projection", &PbrtLights::placeProjection}, {"infinite", &PbrtLights::placeInfinite}};
    const auto found = std::ranges::find(kKinds, kind, &Kind::name);
    if (found == std::end(kKinds)) {
        context_.refuse(params.place(), fmt::format("Glint has no light \"{}\"", kind));
        return;
    }
    (this->*found->place)(params, toWorld);
    params.passOver({"nsamples", "samples"});
    params.finish();
}

/// `powerOfOne`: what leaves one of intensity 1.
Light* PbrtLights::add(const PbrtParams& params, LightKind kind, const std::string& name, float powerOfOne) {
    Light light;
    light.name = name;
    light.kind = kind;
    light.color = colorOf(params, kind == LightKind::Directional ? "L" : "I");
    // pbrt-v3's scale is a colour.
    if (const PbrtParam* scale = params.find("scale"); scale != nullptr && scale->type == PbrtType::Rgb) {
        light.color *= pbrtColor(params, *scale, SpectrumRole::Index);
    } else {
        light.strength = params.number("scale", 1.0f, 0.0f);
    }
    const float power = params.number("power", -1.0f);
    if (power > 0.0f) { light.strength *= power / powerOfOne; }
    context_.scene.lights.push_back(std::move(light));
    return &context_.scene.lights.back();
}

void PbrtLights::placePoint(const PbrtParams& params, const Affine& toWorld) {
    Light* light = add(params, LightKind::Point, "point", 4.0f * kPi);
    light->position = toWorld.point(params.point("from", Vec3(0.0f)));
}

void PbrtLights::placeSpot(const PbrtParams& params, const Affine& toWorld) {
    const float cone = params.number("coneangle", 30.0f, 0.01f, 90.0f);
    const float inner = cone - params.number("conedeltaangle", 5.0f, 0.0f, cone);
    const float a = std::cos(inner / kDegreesPerRadian), b = std::cos(cone / kDegreesPerRadian);
    Light* light = add(params, LightKind::Spot, "spot", kTwoPi * ((1.0f - a) + 0.5f * (a - b)));
    const Vec3 from = params.point("from", Vec3(0.0f)), to = params.point("to", Vec3(0, 0, 1));
    light->position = toWorld.point(from);
    light->direction = toWorld.vector(to - from);
    light->coneAngleDeg = cone;
    light->coneFalloffStartDeg = inner;
    if (isZero(light->direction)) { params.fail("the light points nowhere"); }
}

void PbrtLights::placeDistant(const PbrtParams& params, const Affine& toWorld) {
    Light* light = add(params, LightKind::Directional, "distant", 1.0f);
    const float illuminance = params.number("illuminance", -1.0f);
    if (illuminance > 0.0f) { light->strength *= illuminance; }
    const Vec3 from = params.point("from", Vec3(0.0f)), to = params.point("to", Vec3(0, 0, 1));
    light->direction = toWorld.vector(to - from);
    if (isZero(light->direction)) { params.fail("the light has no direction"); }
}

/// Its image has the local +y in its middle, +x to its right and +z at its bottom.
void PbrtLights::placeGoniometric(const PbrtParams& params, const Affine& toWorld) {
    const bool isLatLong = params.has("mapname");
    std::optional<PbrtValue> image;
    if (isLatLong || params.has("filename")) {
        image = textures_.goniometric(
            params, textures_.imageFile(params, isLatLong ? "mapname" : "filename", ColorEncoding::Srgb),
            isLatLong);
        if (!image) { return; }
    }
    const float mean = image ? luminance(textures_.meanOf(*image)) : 1.0f;
    Light* light = add(params, image ? LightKind::Goniometric : LightKind::Point, "goniometric",
                       4.0f * kPi * std::max(mean, 1e-9f));
    light->position = toWorld.translation;
    if (!image) { return; }
    light->image = textures_.colorInput(*image);
    const Affine toImage{Mat3(1, 0, 0, 0, 0, -1, 0, 1, 0), Vec3(0.0f)};
    if (!aimProjector(toWorld * toImage, Vec3(1, 0, 0), light, &context_.scene)) {
        params.fail("the light is flattened");
    }
}

/// It lights a window of the plane at a distance of 1, which is `fov` wide on its shorter side, with an
/// intensity as the image has it.
void PbrtLights::placeProjection(const PbrtParams& params, const Affine& toWorld) {
    const char* file = params.has("filename") ? "filename" : "mapname";
    if (!params.has(file)) {
        context_.refuse(params.place(), "the projection has no \"filename\"");
        return;
    }
    const float tangent = std::tan(0.5f * params.number("fov", 90.0f, 0.1f, 179.0f) / kDegreesPerRadian);
    float aspect = 1.0f;
    const auto image =
        textures_.projected(params, textures_.imageFile(params, file, ColorEncoding::Srgb), tangent, &aspect);
    if (!image) { return; }
    const float half = tangent * std::max(aspect, 1.0f), area = 4.0f * half * half / aspect;
    Light* light = add(params, LightKind::Projector, "projection",
                       area * std::max(luminance(textures_.meanOf(*image)), 1e-9f));
    light->fovDeg = 2.0f * std::atan(half) * kDegreesPerRadian;
    light->aspect = aspect;
    light->image = textures_.colorInput(*image);
    if (!aimProjector(toWorld, Vec3(1, 0, 0), light, &context_.scene)) {
        params.fail("the light is flattened");
    }
}

void PbrtLights::placeInfinite(const PbrtParams& params, const Affine& toWorld) {
    Environment& environment = context_.scene.environment;
    if (environment.emissive()) {
        params.approximated("environments after the first are left out");
        params.passOver({"L", "filename", "mapname", "scale", "illuminance", "portal"});
        return;
    }
    if (params.has("portal")) { placePortal(params); }
    const bool isLatLong = params.has("mapname");
    environment.color = isLatLong || !params.has("filename") ? colorOf(params, "L") : Vec3(1.0f);
    if (const PbrtParam* scale = params.find("scale"); scale != nullptr && scale->type == PbrtType::Rgb) {
        environment.color *= pbrtColor(params, *scale, SpectrumRole::Index);
    } else {
        environment.strength = params.number("scale", 1.0f, 0.0f);
    }
    if (isLatLong || params.has("filename")) {
        placeMap(params, toWorld, isLatLong);
    } else if (const float illuminance = params.number("illuminance", -1.0f); illuminance > 0.0f) {
        environment.strength *= illuminance / kPi;
    }
}

/// In world space, whatever the light's own transform is. Light leaves against the cross product of its last
/// edge and its first, which a mirror turns over.
void PbrtLights::placePortal(const PbrtParams& params) {
    std::vector<Vec3> corners = params.points("portal");
    for (Vec3& corner : corners) {
        corner = context_.world.point(corner);
    }
    if (context_.failed()) { return; }
    if (!isRectangle(corners)) {
        params.fail("the portal is no rectangle; expected its four corners one after the other");
        return;
    }
    if (glm::determinant(context_.world.linear) < 0.0f) { std::swap(corners[1], corners[3]); }
    context_.scene.environment.portal = std::move(corners);
}

void PbrtLights::placeMap(const PbrtParams& params, const Affine& toWorld, bool isLatLong) {
    Environment& environment = context_.scene.environment;
    const std::string file = context_.fileOf(params.place(), params.text(isLatLong ? "mapname" : "filename"));
    std::vector<std::string> warnings;
    const Result<SceneImage> read = assets_.environment(FileSource{file}, &warnings);
    if (!read) {
        context_.refuse(params.place(),
                        fmt::format("the environment \"{}\" cannot be read: {}", file, read.error().message));
        environment = {};
        return;
    }
    const std::shared_ptr<const ImageF> pixels = linearColors(*read);
    const ImageF& map = *pixels;
    if (!isLatLong && map.width != map.height) {
        params.fail(
            fmt::format("the environment \"{}\" has {} x {} pixels; expected a square, in which equal "
                        "areas are equal solid angles",
                        file, map.width, map.height));
        environment = {};
        return;
    }
    const float illuminance = params.number("illuminance", -1.0f);
    if (const double own = illuminance > 0.0f && !isLatLong ? illuminanceOfEqualArea(map) : 0.0; own > 0.0) {
        environment.strength *= illuminance / static_cast<float>(own);
    }
    environment.image = static_cast<int>(context_.scene.environmentImages.size());
    const ImageF laidOut = isLatLong ? latLongOfPbrt(map, toWorld) : latLongOfEqualArea(map, toWorld);
    context_.scene.environmentImages.push_back({.source = bakedImage(laidOut, file, 0)});
}

int PbrtLights::defineArea(const std::string& kind, PbrtParams params) {
    if (kind != "diffuse" && kind != "area") {
        context_.refuse(params.place(), fmt::format("Glint has no area light \"{}\"", kind));
        return -1;
    }
    areas_.push_back(std::move(params));
    return static_cast<int>(areas_.size()) - 1;
}

PbrtEmission PbrtLights::emissionOf(int number, double area, size_t parts) {
    const PbrtParams& params = areas_[static_cast<size_t>(number)];
    PbrtEmission emission;
    emission.isTwoSided = params.flag("twosided", false);
    emission.color.value = colorOf(params, "L");
    if (const PbrtParam* scale = params.find("scale"); scale != nullptr && scale->type == PbrtType::Rgb) {
        emission.color.value *= pbrtColor(params, *scale, SpectrumRole::Index);
    } else {
        emission.strength = params.number("scale", 1.0f, 0.0f);
    }
    float mean = 1.0f;
    if (params.has("filename")) {
        const PbrtValue image = textures_.imageFile(params, "filename", ColorEncoding::Srgb);
        mean = luminance(textures_.meanOf(image));
        emission.color = textures_.colorInput(image);
    }
    const float power = params.number("power", -1.0f);
    if (power > 0.0f && area > 0.0) {
        if (parts > 2) {
            params.approximated("approximated: the power of meshes is spread evenly over their area");
        }
        const double sides = emission.isTwoSided ? 2.0 : 1.0;
        emission.strength *=
            static_cast<float>(static_cast<double>(power) * static_cast<double>(parts) /
                               (sides * area * static_cast<double>(kPi * maxf(mean, 1e-9f))));
    }
    params.passOver({"nsamples", "samples"});
    params.finish();
    return emission;
}

}  // namespace glint
