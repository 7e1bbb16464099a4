#include "engine/io/mitsuba_sensor.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/io/mitsuba_spectrum.h"

namespace glint {
namespace {

constexpr int kUnlimitedDepth = 1024;  ///< a path of more events than that brings nothing that is seen

void readFilter(MitsubaContext* context, const MitsubaElement* filter) {
    RenderOptions& options = context->scene.options;
    if (filter == nullptr) {  // Mitsuba's default
        options.filter = FilterKind::Gaussian;
        options.filterRadius = 1.5f;
        return;
    }
    MitsubaObject object(context, *filter);
    if (object.type() == "box") {
        options.filter = FilterKind::Box;
        options.filterRadius = std::clamp(object.number("radius", 0.5f), 0.01f, 16.0f);
        if (std::fabs(options.filterRadius - 0.5f) < 1e-3f) { options.filterRadius = 0.5f; }
    } else {
        if (object.type() != "gaussian") {
            object.approximated("approximated: the reconstruction filter is a Gaussian");
        }
        options.filter = FilterKind::Gaussian;  // ends at three standard deviations, Mitsuba's at four
        options.filterRadius = std::clamp(3.0f * object.number("stddev", 0.5f), 0.01f, 16.0f);
        object.passOver({"b", "c", "lobes", "radius"});
    }
    object.finish();
}

/// The picture that a camera looks at, and where the window lies whose pixels alone are there.
struct FilmWindow {
    Resolution whole{768, 576};
    Resolution shown{768, 576};
    int left = 0, top = 0;

    float aspect() const { return static_cast<float>(whole.width) / static_cast<float>(whole.height); }
};

FilmWindow readFilm(MitsubaContext* context, const MitsubaElement* film) {
    FilmWindow window;
    if (film == nullptr) {
        readFilter(context, nullptr);
        return window;
    }
    MitsubaObject object(context, *film);
    Resolution& whole = window.whole;
    whole.width = object.integer("width", 768, 1, 32768);
    whole.height = object.integer("height", 576, 1, 32768);
    window.shown.width = object.integer("crop_width", whole.width, 1, 32768);
    window.shown.height = object.integer("crop_height", whole.height, 1, 32768);
    window.left = object.integer("crop_offset_x", 0, 0, 32768);
    window.top = object.integer("crop_offset_y", 0, 0, 32768);
    if (window.left + window.shown.width > whole.width || window.top + window.shown.height > whole.height) {
        context->fail(
            *film, fmt::format("the crop window of {} x {} pixels at {}, {} reaches beyond the picture of {} "
                               "x {}",
                               window.shown.width, window.shown.height, window.left, window.top, whole.width,
                               whole.height));
    }
    object.passOver({"pixel_format", "component_format", "file_format", "banner", "gamma", "exposure", "key",
                     "burn", "tonemap_method", "attach_log", "high_quality_edges", "sample_border",
                     "compensate", "channel_format", "variable", "digits"});
    readFilter(context, object.next({"rfilter"}));
    object.finish();
    return window;
}

/// Parallel rays: the whole picture is two units wide, which the camera's transform stretches.
void setParallel(const Vec3& x, const Vec3& up, float aspect, Camera* camera) {
    const float width = glm::length(x), height = glm::length(up);
    camera->kind = ProjectionKind::Orthographic;
    camera->viewHeight = 2.0f * height / aspect;
    if (std::fabs(width - height) > 1e-6f * height) { camera->horizontalScale = width / height; }
}

/// The window of a camera whose principal point, the middle of the whole picture, was moved by these shares
/// of its width and height.
void showWindow(const FilmWindow& window, const Vec2& principal, Camera* camera) {
    const Vec2 whole(window.whole.width, window.whole.height);
    const Vec2 shown(window.shown.width, window.shown.height);
    const Vec2 middle = Vec2(window.left, window.top) + 0.5f * (shown - whole) + principal * whole;
    camera->shift = (Vec2(middle.x, 0.0f) - Vec2(0.0f, middle.y)) / shown.y;
    if (window.shown.height == window.whole.height) { return; }
    const float share = shown.y / whole.y;
    camera->viewHeight *= share;
    camera->verticalFovDeg = 2.0f *
                             std::atan(share * std::tan(0.5f * camera->verticalFovDeg / kDegreesPerRadian)) *
                             kDegreesPerRadian;
}

/// A <lookat> that nothing but scales of the picture comes before says the camera's points themselves, which
/// no rounding then changes.
void lookAsWritten(MitsubaContext* context, const MitsubaElement* transform, Camera* read) {
    if (transform == nullptr || transform->children.empty()) { return; }
    const MitsubaElement& look = transform->children.back();
    const auto isScale = [](const MitsubaElement& each) { return each.tag == "scale"; };
    if (look.tag != "lookat" ||
        !std::all_of(transform->children.begin(), transform->children.end() - 1, isScale)) {
        return;
    }
    Camera written = *read, *camera = &written;
    const auto point = [&](std::string_view name, Vec3* out) {
        if (!look.has(name)) { return; }
        const auto v = mitsubaNumbers(context, look, look.attribute(name), {3});
        if (v.size() == 3) { *out = Vec3(glm::dvec3(v[0], v[1], v[2])); }
    };
    point("origin", &camera->position);
    point("target", &camera->target);
    if (look.has("up")) { point("up", &camera->up); }
    // Scales below zero turn the picture over.
    if (glm::dot(axesOf(written).forward, axesOf(*read).forward) > 0.0f &&
        glm::dot(axesOf(written).up, axesOf(*read).up) > 0.0f) {
        *read = written;
    }
}

}  // namespace

float mitsubaVerticalFov(MitsubaObject* object, float aspect) {
    constexpr float kDiagonalMm = 43.2666153f;  // of 36 x 24 mm
    std::string_view axis = object->text("fov_axis", "x");
    float fov = 0.0f;
    if (object->property("fov") != nullptr) {
        fov = object->number("fov", 40.0f, 0.01f, 179.9f);
    } else {
        std::string_view length = object->text("focal_length", "50mm");
        if (length.ends_with("mm")) { length.remove_suffix(2); }
        const double mm = mitsubaNumber(&object->context(), object->element(), length);
        fov = 2.0f * std::atan(0.5f * kDiagonalMm / std::max(static_cast<float>(mm), 1e-3f)) *
              kDegreesPerRadian;
        axis = "diagonal";
    }
    if (axis == "y") { return fov; }
    const float tangent = std::tan(0.5f * fov / kDegreesPerRadian);
    const bool isVertical = (axis == "smaller" && aspect > 1.0f) || (axis == "larger" && aspect < 1.0f);
    const float vertical = isVertical           ? tangent
                           : axis == "diagonal" ? tangent / std::sqrt(1.0f + aspect * aspect)
                                                : tangent / aspect;
    return std::clamp(2.0f * std::atan(vertical) * kDegreesPerRadian, 1e-3f, 179.99f);
}

void readMitsubaSensor(MitsubaContext* context, const MitsubaElement& sensor) {
    MitsubaObject object(context, sensor);
    const FilmWindow window = readFilm(context, object.next({"film"}));
    context->scene.resolution = window.shown;
    const std::string_view type = object.type();
    const bool isOrthographic = type == "orthographic", hasLens = type == "thinlens";
    if (!isOrthographic && !hasLens && type != "perspective") {
        context->refuse(sensor, fmt::format("Glint has no sensor \"{}\"", type));
        return;
    }
    object.next({"sampler"});
    Affine toWorld = object.transform();
    if (context->failed() || !isInvertible(toWorld)) {
        context->fail(sensor, "the camera's transform is flattened");
        return;
    }
    if (toWorld.determinant() < 0.0f) {
        const Affine mirror = scale(Vec3(-1, 1, 1));
        context->world = toWorld * mirror * inverse(toWorld);
        toWorld = toWorld * mirror;
        context->note(sensor, "the camera mirrors: the scene is mirrored in its place");
    }
    const Vec3 x = toWorld.linear[0], up = toWorld.linear[1], forward = toWorld.linear[2];
    const float length = glm::length(forward);
    Camera& camera = context->scene.camera;
    camera.position = toWorld.translation;
    camera.up = glm::normalize(up);
    // What rounding leaves of a unit length is 1.
    const float unit = std::fabs(length - 1.0f) < 1e-6f ? 1.0f : length;
    camera.focalDistance = unit * object.number("focus_distance", 1.0f, 1e-6f);
    camera.target = camera.position + forward / length;
    if (isOrthographic) {
        setParallel(x, up, window.aspect(), &camera);
    } else {
        camera.verticalFovDeg = mitsubaVerticalFov(&object, window.aspect());
        camera.apertureDiameter = hasLens ? 2.0f * unit * object.number("aperture_radius", 0.0f, 0.0f) : 0.0f;
        camera.target = camera.position + (camera.focalDistance / length) * forward;
    }
    lookAsWritten(context, object.property("to_world"), &camera);
    showWindow(window,
               {object.number("principal_point_offset_x", 0.0f, -1e4f, 1e4f),
                object.number("principal_point_offset_y", 0.0f, -1e4f, 1e4f)},
               &camera);
    if (object.property("near_clip") != nullptr || object.property("far_clip") != nullptr) {
        object.passOver({"near_clip", "far_clip"});
        context->note(sensor, "near and far planes do not cut");
    }
    object.passOver({"shutter_open", "shutter_close", "fov", "srf"});
    object.finish();
}

void readMitsubaIntegrator(MitsubaContext* context, const MitsubaElement& integrator) {
    MitsubaObject object(context, integrator);
    if (context->failed()) { return; }
    if (const MitsubaElement* inner = object.next({"integrator"})) {  // moment, aov, adaptive, irrcache
        readMitsubaIntegrator(context, *inner);
        return;
    }
    RenderOptions& options = context->scene.options;
    const std::string_view type = object.type();
    const bool isPhotons = type == "sppm" || type == "ppm" || type == "photonmapper";
    options.integrator = isPhotons      ? IntegratorKind::Sppm
                         : type == "ao" ? IntegratorKind::AmbientOcclusion
                                        : IntegratorKind::PathTracing;
    const bool isDirect = type == "direct";
    const int depth = object.integer("max_depth", isDirect ? 2 : -1, -1, 1 << 20);
    options.maxDepth = depth < 0 ? kUnlimitedDepth : std::max(depth - 1, 0);
    options.rouletteStartDepth = object.integer("rr_depth", 5, 1, 1 << 20);
    if (object.flag("hide_emitters", false)) {
        object.approximated("approximated: lights and the environment are seen");
    }
    if (type != "path" && !isDirect && !isPhotons && type != "ao") {
        context->note(integrator, "the integrator is path tracing", type);
    }
    if (isPhotons) {
        SppmOptions& sppm = context->scene.sppm;
        sppm.alpha = object.number("alpha", sppm.alpha, 0.01f, 0.99f);
        sppm.radiusWorld = object.number("initial_radius", 0.0f, 0.0f);
        sppm.photonsPerPass = static_cast<uint32_t>(object.integer("photon_count", 262144, 1, 1 << 30));
        object.passOver({"max_passes", "global_photons", "caustic_photons", "volume_photons"});
    }
    object.passOver({"strict_normals", "emitter_samples", "bsdf_samples", "shading_samples", "samples",
                     "light_samples", "ray_length", "aovs", "granularity", "auto_cancel_threshold"});
    object.finish();
}

}  // namespace glint
