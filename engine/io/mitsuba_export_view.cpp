// Camera, film and integrator as Mitsuba 3 has them.
#include <algorithm>

#include <fmt/format.h>

#include "engine/io/mitsuba_writer.h"
#include "engine/io/scene_export.h"

namespace glint {
namespace {

void writeIntegrator(const SceneDescription& scene, MitsubaWriter* out, std::vector<std::string>* warnings) {
    const RenderOptions& options = scene.options;
    if (options.integrator != IntegratorKind::PathTracing) {
        warnOnce("approximated: the integrator is path tracing", warnings);
    }
    if (options.fireflyClamp > 0.0f) { warnOnce("approximated: samples are not clamped", warnings); }
    // Mitsuba's "path" passes media by.
    const bool hasMedia = std::ranges::any_of(scene.objects, [&](const Object& object) {
        return absorbsInside(scene.materials[static_cast<size_t>(object.material)]);
    });
    out->open("integrator", hasMedia ? "type=\"volpath\"" : "type=\"path\"");
    out->integer("max_depth", options.maxDepth + 1);
    out->integer("rr_depth", std::max(options.rouletteStartDepth, 1));
    out->close();
}

void writeFilm(const SceneDescription& scene, MitsubaWriter* out, std::vector<std::string>* warnings) {
    const RenderOptions& options = scene.options;
    out->open("film", "type=\"hdrfilm\"");
    out->integer("width", scene.resolution.width);
    out->integer("height", scene.resolution.height);
    if (options.filter == FilterKind::Box) {
        out->open("rfilter", "type=\"box\"");
        if (options.filterRadius != 0.5f) { out->number("radius", options.filterRadius); }
    } else {
        if (options.filter != FilterKind::Gaussian) {
            warnOnce("approximated: the filter is a Gaussian", warnings);
        }
        out->open("rfilter", "type=\"gaussian\"");
        out->number("stddev", options.filterRadius / 3.0f);
    }
    out->close();
    out->close();
}

void writePlace(const Camera& camera, const Vec3& offset, MitsubaWriter* out) {
    out->element("lookat",
                 fmt::format("origin=\"{}\" target=\"{}\" up=\"{}\"", xmlNumbers(camera.position + offset),
                             xmlNumbers(camera.target + offset), xmlNumbers(camera.up)));
}

void writePerspective(const Camera& camera, float aspect, MitsubaWriter* out,
                      std::vector<std::string>* warnings) {
    const bool hasLens = camera.apertureDiameter > 0.0f;
    out->open("sensor", fmt::format("type=\"{}\"", hasLens ? "thinlens" : "perspective"));
    out->open("transform", "name=\"to_world\"");
    writePlace(camera, Vec3(0.0f), out);
    out->close();
    out->string("fov_axis", "y");
    out->number("fov", camera.verticalFovDeg);
    if (hasLens) {
        out->number("aperture_radius", 0.5f * camera.apertureDiameter);
        out->number("focus_distance", camera.focalDistance);
        if (camera.apertureBlades > 0) { warnOnce("approximated: the aperture is round", warnings); }
    }
    if (camera.horizontalScale != 1.0f) { warnOnce("approximated: pixels are square", warnings); }
    if (camera.shift == Vec2(0.0f)) { return; }
    if (hasLens) { return warnOnce("approximated: the lens is not shifted", warnings); }
    out->number("principal_point_offset_x", camera.shift.x / aspect);
    out->number("principal_point_offset_y", -camera.shift.y);
}

/// A shift of parallel rays is a step aside.
void writeParallel(const Camera& camera, float aspect, MitsubaWriter* out,
                   std::vector<std::string>* warnings) {
    out->open("sensor", "type=\"orthographic\"");
    out->open("transform", "name=\"to_world\"");
    const float half = 0.5f * camera.viewHeight * aspect;
    out->element("scale", fmt::format("x=\"{}\" y=\"{}\"", half * camera.horizontalScale, half));
    const CameraAxes axes = axesOf(camera);
    const Vec2 aside = camera.viewHeight * camera.shift * Vec2(camera.horizontalScale, 1.0f);
    writePlace(camera, axes.right * aside.x + axes.up * aside.y, out);
    out->close();
    if (camera.apertureDiameter > 0.0f) { warnOnce("approximated: all is in focus", warnings); }
}

}  // namespace

void writeMitsubaView(const SceneDescription& scene, MitsubaWriter* out, std::vector<std::string>* warnings) {
    writeIntegrator(scene, out, warnings);
    const Camera& camera = scene.camera;
    const float aspect =
        static_cast<float>(scene.resolution.width) / static_cast<float>(scene.resolution.height);
    if (camera.kind == ProjectionKind::Orthographic) {
        writeParallel(camera, aspect, out, warnings);
    } else {
        writePerspective(camera, aspect, out, warnings);
    }
    writeFilm(scene, out, warnings);
    out->close();
}

}  // namespace glint
