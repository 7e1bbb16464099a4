#include "engine/io/pbrt_camera.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/io/pbrt_color.h"

namespace glint {
namespace {

/// The scene's own x is turned over, which changes none of its numbers.
const Affine kMirror{Mat3(-1, 0, 0, 0, 1, 0, 0, 0, 1), Vec3(0.0f)};

}  // namespace

void PbrtView::setCamera(const std::string& kind, PbrtParams params, const PbrtState& state) {
    hasCamera_ = true;
    cameraKind_ = kind;
    camera_ = std::move(params);
    cameraFromWorld_ = state.transform;
    look_ = state.look;
}

void PbrtView::setFilm(const std::string& kind, PbrtParams params) {
    if (kind != "rgb" && kind != "image") {
        params.approximated("approximated: films of another kind are of red, green and blue");
    }
    hasFilm_ = true;
    film_ = std::move(params);
}

void PbrtView::setFilter(const std::string& kind, const PbrtParams& params) {
    RenderOptions& options = context_.scene.options;
    if (kind == "box") {
        options.filter = FilterKind::Box;
        options.filterRadius = params.number("xradius", params.number("xwidth", 0.5f), 0.01f, 16.0f);
        params.passOver({"yradius", "ywidth", "xwidth"});
    } else {
        if (kind != "gaussian") { params.approximated("approximated: the filter is a Gaussian"); }
        options.filter = FilterKind::Gaussian;  // ends at three standard deviations
        options.filterRadius = std::clamp(3.0f * params.number("sigma", 0.5f, 0.01f, 5.0f), 0.01f, 16.0f);
        params.passOver({"xradius", "yradius", "xwidth", "ywidth", "alpha", "B", "C", "tau"});
    }
    params.finish();
}

void PbrtView::setIntegrator(const std::string& kind, const PbrtParams& params) {
    RenderOptions& options = context_.scene.options;
    const bool isPhotons = kind == "sppm";
    options.integrator = isPhotons                    ? IntegratorKind::Sppm
                         : kind == "ambientocclusion" ? IntegratorKind::AmbientOcclusion
                                                      : IntegratorKind::PathTracing;
    // Both count scattering events.
    options.maxDepth = params.integer("maxdepth", 5, 0, 1 << 20);
    if (isPhotons) {
        SppmOptions& sppm = context_.scene.sppm;
        sppm.radiusWorld = params.number("radius", params.number("initialradius", 1.0f, 0.0f), 0.0f);
        const int photons = params.integer("photonsperiteration", -1, -1, 1 << 30);
        if (photons > 0) { sppm.photonsPerPass = static_cast<uint32_t>(photons); }
    } else if (kind != "path" && kind != "volpath" && kind != "ambientocclusion") {
        context_.note(params.place(), "the integrator is path tracing", kind);
    }
    params.passOver({"lightsampler", "lightsamplestrategy", "regularize", "rrthreshold", "seed", "iterations",
                     "imagewritefrequency", "visualizestrategies", "visualizeweights", "samplelights",
                     "samplebsdf", "pixelbounds", "initialradius", "numiterations", "cossample",
                     "maxdistance"});
    params.finish();
}

/// "cropwindow" counts in shares of the picture, "pixelbounds" in pixels; both from the left and the top.
PbrtView::Window PbrtView::readWindow(const Resolution& whole) {
    Window window{whole, Vec2i(0), Vec2i(whole.width, whole.height)};
    const Vec2i size = window.high;
    const std::vector<int>& pixels = film_.integers("pixelbounds", 4);
    const std::vector<float>& shares = film_.numbers("cropwindow", 4);
    if (shares.size() >= 4) {
        const auto at = [&](size_t i, int axis) {
            return static_cast<int>(
                std::ceil(std::clamp(shares[i], 0.0f, 1.0f) * static_cast<float>(size[axis])));
        };
        window.low = {at(0, 0), at(2, 1)};
        window.high = {at(1, 0), at(3, 1)};
    } else if (pixels.size() >= 4) {
        window.low = glm::clamp(Vec2i(pixels[0], pixels[2]), Vec2i(0), size);
        window.high = glm::clamp(Vec2i(pixels[1], pixels[3]), Vec2i(0), size);
    }
    if (window.high.x <= window.low.x || window.high.y <= window.low.y) {
        film_.fail("the film's crop window holds no pixel");
        window.high = window.low + Vec2i(1);
    }
    return window;
}

PbrtView::Window PbrtView::readFilm() {
    exposure_ = 1.0f;
    if (hasCamera_) {
        const float seconds = camera_.number("shutterclose", 1.0f) - camera_.number("shutteropen", 0.0f);
        exposure_ = seconds > 0.0f ? seconds : 1.0f;
    }
    if (!hasFilm_) { return {}; }
    Resolution whole;
    whole.width = film_.integer("xresolution", 1280, 1, 32768);
    whole.height = film_.integer("yresolution", 720, 1, 32768);
    const Window window = readWindow(whole);
    exposure_ *= film_.number("iso", 100.0f, 1e-6f) / 100.0f;
    readSensor();
    const float most = film_.number("maxcomponentvalue", 0.0f, 0.0f);
    if (most > 0.0f && most < 1e18f) {
        context_.scene.options.fireflyClamp = most;
        context_.note(film_.place(),
                      "samples brighter than the film's \"maxcomponentvalue\" are darkened to it");
    }
    film_.passOver({"filename", "diagonal", "savefp16", "maxsampleluminance", "lambdamin", "lambdamax",
                    "nbuckets", "coordinatesystem", "scale", "exposuretime"});
    film_.finish();
    return window;
}

/// Sensors of cameras have their own responses in pbrt, and balance white even unasked; that of the observer
/// does so where the film says for which light.
void PbrtView::readSensor() {
    constexpr std::string_view kObserver = "cie1931";
    constexpr float kUsualKelvin = 6500.0f;
    const std::string sensor = film_.text("sensor", kObserver);
    const float kelvin = film_.number("whitebalance", 0.0f, 0.0f);
    if (sensor != kObserver) {
        context_.remark(film_.place(), "approximated: sensors of cameras see as the CIE's observer does",
                        sensor);
    }
    if (kelvin == 0.0f && sensor == kObserver) { return; }
    const double white = static_cast<double>(kelvin == 0.0f ? kUsualKelvin : std::clamp(kelvin, 1e3f, 25e3f));
    balance_ = pbrtWhiteBalance(white);
    if (kelvin != 0.0f) {
        film_.approximated("approximated: white is balanced in the lights, not on the film");
    }
}

PbrtView::Screen PbrtView::readScreen(const Window& window) {
    const Vec2 pixels(window.whole.width, window.whole.height);
    const float ratio = camera_.number("frameaspectratio", pixels.x / pixels.y, 1e-6f, 1e6f);
    Screen screen{Vec2(0.0f), ratio > 1.0f ? Vec2(ratio, 1.0f) : Vec2(1.0f, 1.0f / ratio)};
    if (const std::vector<float>& given = camera_.numbers("screenwindow", 4); given.size() >= 4) {
        const Vec2 low(given[0], given[2]), high(given[1], given[3]);
        if (!(high.x > low.x && high.y > low.y)) {
            camera_.fail("expected the screen window's least x, most x, least y and most y");
            return screen;
        }
        screen = {0.5f * (low + high), 0.5f * (high - low)};
    }
    if (window.low == Vec2i(0) && Vec2(window.high) == pixels) { return screen; }
    const Vec2 perPixel = 2.0f * screen.half / pixels;
    const Vec2 aside = 0.5f * (Vec2(window.low) + Vec2(window.high) - pixels);
    return {screen.middle + perPixel * Vec2(aside.x, -aside.y),
            0.5f * perPixel * Vec2(window.high - window.low)};
}

void PbrtView::finish() {
    const Window window = readFilm();
    context_.scene.resolution = {window.high.x - window.low.x, window.high.y - window.low.y};
    if (exposure_ != 1.0f) {
        context_.note(film_.place(), "the film's exposure is in the strengths of the lights",
                      fmt::format("{:g}", exposure_));
    }
    if (!hasCamera_ || context_.failed()) { return; }
    placeCamera(readScreen(window));
    camera_.passOver({"shutteropen", "shutterclose"});
    camera_.finish();
}

float PbrtView::readLens(const Screen& screen, float unit) {
    Camera& camera = context_.scene.camera;
    camera.focalDistance = std::clamp(unit * camera_.number("focaldistance", 1e6f), 1e-6f, 1e9f);
    camera.apertureDiameter = 2.0f * unit * camera_.number("lensradius", 0.0f, 0.0f);
    if (cameraKind_ == "realistic") {
        camera_.approximated("approximated: lenses of several glasses are one thin lens of 50 mm");
        constexpr float kFocalLength = 0.05f, kFilmDiagonal = 0.035f;
        camera.apertureDiameter = 1e-3f * unit * camera_.number("aperturediameter", 1.0f, 0.0f);
        camera.focalDistance = unit * camera_.number("focusdistance", 10.0f, 1e-6f, 1e9f);
        camera_.passOver({"lensfile", "aperture", "scale"});
        return 0.5f * kFilmDiagonal / (kFocalLength * glm::length(screen.half));
    }
    if (cameraKind_ == "orthographic") {
        camera.kind = ProjectionKind::Orthographic;
        return 1.0f;
    }
    if (cameraKind_ == "perspective") {
        const float fov =
            camera_.has("halffov") ? 2.0f * camera_.number("halffov", 45.0f) : camera_.number("fov", 90.0f);
        camera.verticalFovDeg = std::clamp(fov, 0.01f, 179.9f);
        return std::tan(0.5f * camera.verticalFovDeg / kDegreesPerRadian);
    }
    camera_.approximated("approximated: cameras of another kind are perspective ones of 90 degrees");
    camera_.passOver({"mapping"});
    return 1.0f;
}

void PbrtView::placeCamera(const Screen& screen) {
    const double size = glm::determinant(cameraFromWorld_);
    Affine toWorld =
        affineOf(&context_, camera_.place(), size != 0.0 ? glm::inverse(cameraFromWorld_) : glm::dmat4(0.0));
    if (!isInvertible(toWorld)) { camera_.fail("the camera's transform is flattened"); }
    if (context_.failed()) { return; }
    if (toWorld.determinant() > 0.0f) {
        context_.world = kMirror;
        context_.note(camera_.place(), "pbrt's camera is left-handed: the scene's x is turned over");
    }
    toWorld = context_.world * toWorld;
    // What rounding leaves of squares and lengths is 1.
    const auto nearlyOne = [](float x) { return std::fabs(x - 1.0f) < 1e-4f ? 1.0f : x; };
    const Vec3 forward = toWorld.linear[2];
    const float unit = nearlyOne(glm::length(forward));
    Camera& camera = context_.scene.camera;
    camera.position = toWorld.translation;
    camera.up = glm::normalize(toWorld.linear[1]);
    const float length = readLens(screen, unit);
    const float perUnit = camera.kind == ProjectionKind::Orthographic ? 1.0f : unit;
    const float across = nearlyOne(glm::length(toWorld.linear[0]) / perUnit);
    const float upwards = nearlyOne(glm::length(toWorld.linear[1]) / perUnit);
    const Vec2 half = screen.half * Vec2(across, upwards);
    const Resolution& pixels = context_.scene.resolution;
    camera.horizontalScale =
        nearlyOne(half.x / half.y * static_cast<float>(pixels.height) / static_cast<float>(pixels.width));
    const Vec2 middle = screen.middle * Vec2(across / camera.horizontalScale, upwards);
    camera.shift = middle / (2.0f * half.y);
    camera.viewHeight = 2.0f * half.y;
    if (half.y != 1.0f || cameraKind_ != "perspective") {
        camera.verticalFovDeg =
            std::clamp(2.0f * std::atan(length * half.y) * kDegreesPerRadian, 1e-3f, 179.99f);
    }
    const float reach = camera.focalDistance < 1e5f * unit ? camera.focalDistance : unit;
    camera.target = camera.position + (reach / unit) * forward;
    lookAsWritten();
}

/// A single LookAt says the camera's points themselves, which no rounding then changes.
void PbrtView::lookAsWritten() {
    if (look_.size() < 9) { return; }
    const auto pointAt = [&](size_t i) {
        return context_.world.vector(Vec3(glm::dvec3(look_[i], look_[i + 1], look_[i + 2])));
    };
    Camera& camera = context_.scene.camera;
    camera.position = pointAt(0);
    camera.target = pointAt(3);
    camera.up = pointAt(6);
}

void scaleLight(float exposure, const Mat3& balance, SceneDescription* scene) {
    const auto balanced = [&](const Vec3& color, bool isImage) {
        if (balance == Mat3(1.0f)) { return color; }
        return glm::max(isImage ? color * (balance * Vec3(1.0f)) : balance * color, Vec3(0.0f));
    };
    for (Material& material : scene->materials) {
        material.emissionStrength *= exposure;
        material.emission.value = balanced(material.emission.value, false);
    }
    for (Light& light : scene->lights) {
        light.strength *= exposure;
        light.color = balanced(light.color, false);
    }
    Environment& environment = scene->environment;
    environment.strength *= exposure;
    environment.color = balanced(environment.color, environment.image >= 0);
}

}  // namespace glint
