#include "engine/io/pbrt_writer.h"

#include <algorithm>

#include <fmt/format.h>

#include "engine/io/scene_export.h"

namespace glint {

std::string pbrtQuoted(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') { out += '\\'; }
        out += c;
    }
    return out + '"';
}

std::string pbrtNumber(std::string_view name, float value) {
    return fmt::format(" \"float {}\" {}", name, value);
}
std::string pbrtInteger(std::string_view name, int value) {
    return fmt::format(" \"integer {}\" {}", name, value);
}
std::string pbrtFlag(std::string_view name, bool value) {
    return fmt::format(" \"bool {}\" {}", name, value);
}
std::string pbrtString(std::string_view name, std::string_view value) {
    return fmt::format(" \"string {}\" {}", name, pbrtQuoted(value));
}
std::string pbrtRgb(std::string_view name, const Vec3& v) {
    return fmt::format(" \"rgb {}\" [{} {} {}]", name, v.x, v.y, v.z);
}
std::string pbrtPoint(std::string_view name, const Vec3& v) {
    return fmt::format(" \"point3 {}\" [{} {} {}]", name, v.x, v.y, v.z);
}
std::string pbrtPoints(std::string_view name, const std::vector<Vec3>& values) {
    std::string out = fmt::format(" \"point3 {}\" [", name);
    for (const Vec3& v : values) {
        out += fmt::format("{}{} {} {}", out.ends_with('[') ? "" : "  ", v.x, v.y, v.z);
    }
    return out + "]";
}

std::string pbrtTextureName(int index, bool isNumber) {
    return fmt::format("t{}{}", index, isNumber ? "n" : "");
}

std::string pbrtColorInput(std::string_view name, const ColorInput& input) {
    return input.texture >= 0
               ? fmt::format(" \"texture {}\" \"{}\"", name, pbrtTextureName(input.texture, false))
               : pbrtRgb(name, input.value);
}

std::string pbrtNumberInput(std::string_view name, const NumberInput& input) {
    return input.texture >= 0
               ? fmt::format(" \"texture {}\" \"{}\"", name, pbrtTextureName(input.texture, true))
               : pbrtNumber(name, input.value);
}

std::string pbrtTexture(const SceneDescription& scene, int index, bool isNumber,
                        std::vector<std::string>* warnings) {
    const Texture& t = scene.textures[static_cast<size_t>(index)];
    const auto* board = std::get_if<Checkerboard>(&t.image.source);
    const float squares = board != nullptr ? 2.0f : 1.0f;  // of pbrt's checkerboards, one lies on each unit
    std::string out =
        fmt::format("Texture \"{}\" \"{}\" \"{}\"", pbrtTextureName(index, isNumber),
                    isNumber ? "float" : "spectrum", board != nullptr ? "checkerboard" : "imagemap");
    out += pbrtNumber("uscale", squares * t.scale.x) + pbrtNumber("vscale", squares * t.scale.y) +
           pbrtNumber("udelta", squares * t.offset.x) + pbrtNumber("vdelta", squares * t.offset.y);
    if (t.rotationDeg != 0.0f || t.flipV) { warnOnce("approximated: textures are not turned", warnings); }
    if (board != nullptr) {
        out += isNumber ? pbrtNumber("tex1", board->even.x) + pbrtNumber("tex2", board->odd.x)
                        : pbrtRgb("tex1", board->even) + pbrtRgb("tex2", board->odd);
        return out + "\n";
    }
    out += pbrtString("filename", pathOf(t.image.source));
    if (t.wrapU == WrapMode::Clamp && t.wrapV == WrapMode::Clamp) {
        out += pbrtString("wrap", "clamp");
    } else if (t.wrapU != WrapMode::Repeat || t.wrapV != WrapMode::Repeat) {
        warnOnce("approximated: images repeat", warnings);
    }
    if (t.filter == TexelFilter::Nearest) { out += pbrtString("filter", "point"); }
    if (isNumber || t.encoding == ColorEncoding::Linear) { out += pbrtString("encoding", "linear"); }
    const bool isInverted = t.base == 1.0f && t.gain < 0.0f;
    if (t.gain != 1.0f) { out += pbrtNumber("scale", std::fabs(t.gain)); }
    if (isInverted) { out += pbrtFlag("invert", true); }
    if (t.exponent != 1.0f || (t.base != 0.0f && !isInverted)) {
        warnOnce("approximated: images are shown without exponents", warnings);
    }
    return out + "\n";
}

std::string pbrtView(const SceneDescription& scene, std::vector<std::string>* warnings) {
    const RenderOptions& options = scene.options;
    if (options.integrator != IntegratorKind::PathTracing) {
        warnOnce("approximated: the integrator is path tracing", warnings);
    }
    std::string out = "Integrator \"volpath\"" + pbrtInteger("maxdepth", options.maxDepth) + "\n";
    if (options.filter == FilterKind::Box) {
        out += "PixelFilter \"box\"" + pbrtNumber("xradius", options.filterRadius) +
               pbrtNumber("yradius", options.filterRadius) + "\n";
    } else {
        if (options.filter != FilterKind::Gaussian) {
            warnOnce("approximated: the filter is a Gaussian", warnings);
        }
        out += "PixelFilter \"gaussian\"" + pbrtNumber("sigma", options.filterRadius / 3.0f) +
               pbrtNumber("xradius", options.filterRadius) + pbrtNumber("yradius", options.filterRadius) +
               "\n";
    }
    out += "Film \"rgb\"" + pbrtInteger("xresolution", scene.resolution.width) +
           pbrtInteger("yresolution", scene.resolution.height);
    if (options.fireflyClamp > 0.0f) { out += pbrtNumber("maxcomponentvalue", options.fireflyClamp); }
    const Camera& camera = scene.camera;
    const auto look = [](const Vec3& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); };
    const bool isParallel = camera.kind == ProjectionKind::Orthographic;
    out += fmt::format("\nScale -1 1 1\nLookAt {}  {}  {}\nCamera \"{}\"", look(camera.position),
                       look(camera.target), look(camera.up), isParallel ? "orthographic" : "perspective");
    const float aspect =
        static_cast<float>(scene.resolution.width) / static_cast<float>(scene.resolution.height);
    const Vec2 half(aspect * camera.horizontalScale, 1.0f);
    const Vec2 middle = 2.0f * camera.shift * Vec2(camera.horizontalScale, 1.0f);
    const float unit = isParallel ? 0.5f * camera.viewHeight : 1.0f;
    const Vec2 low = unit * (middle - half), high = unit * (middle + half);
    if (!isParallel) { out += pbrtNumber("fov", camera.verticalFovDeg); }
    out += fmt::format(" \"float screenwindow\" [{} {} {} {}]", low.x, high.x, low.y, high.y);
    if (camera.apertureDiameter > 0.0f) {
        out += pbrtNumber("lensradius", 0.5f * camera.apertureDiameter) +
               pbrtNumber("focaldistance", camera.focalDistance);
        if (camera.apertureBlades > 0) { warnOnce("approximated: the aperture is round", warnings); }
    }
    return out + "\nWorldBegin\n";
}

}  // namespace glint
