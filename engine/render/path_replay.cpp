#include "engine/render/path_replay.h"

#include <fmt/format.h>

#include "engine/kernels/path_kernel.h"
#include "engine/render/cpu_variants.h"

namespace glint {
namespace {

std::string format(const Vec3& v) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x, v.y, v.z); }

/// All digits that a place far from the origin has.
std::string formatPlace(const Vec3& p) { return fmt::format("({:.7g}, {:.7g}, {:.7g})", p.x, p.y, p.z); }

bool isFaulty(const Vec3& value) { return findFault(value) != SampleFault::None; }

const char* faultName(SampleFault fault) {
    switch (fault) {
        case SampleFault::None:
            return "kept";
        case SampleFault::NotANumber:
            return "dropped: not a number";
        case SampleFault::Infinite:
            return "dropped: infinite";
        case SampleFault::Negative:
            return "dropped: negative";
    }
    return "";
}

std::string formatHitLight(const char* what, const PathEvent& e) {
    return fmt::format("  {} adds {}\n    pdf by BSDF {:.6g}, by light {:.6g} per sr, weight {:.6g}\n", what,
                       format(e.value), e.pdfBsdf, e.pdfLight, e.weight);
}

std::string formatVertex(const PathEvent& e) {
    return fmt::format(
        "vertex {}: object {} triangle {} material {}\n  position {} normal {}\n  throughput {}\n", e.depth,
        e.instance, e.primitive, e.material, formatPlace(e.position), format(e.normal), format(e.throughput));
}

std::string formatLight(const PathEvent& e) {
    return fmt::format(
        "  light {}{} adds {}\n    towards {} at {}\n    pdf by light {:.6g}, by BSDF {:.6g} per sr, weight "
        "{:.6g}\n",
        e.emitter, e.flag ? " (shadowed)" : "", format(e.value), format(e.direction), formatPlace(e.position),
        e.pdfLight, e.pdfBsdf, e.weight);
}

std::string formatEvent(const PathEvent& e) {
    switch (e.kind) {
        case PathEventKind::Camera:
            return fmt::format("camera ray from {} towards {}\n", formatPlace(e.position),
                               format(e.direction));
        case PathEventKind::Vertex:
            return formatVertex(e);
        case PathEventKind::Emission:
            return formatHitLight("emission", e);
        case PathEventKind::Escape:
            return "leaves the scene\n" + formatHitLight("environment", e);
        case PathEventKind::Light:
            return formatLight(e);
        case PathEventKind::Scatter:
            return fmt::format("  scatters towards {}{}\n    weight {}, pdf {:.6g} per sr\n",
                               format(e.direction), e.flag ? " (specular)" : "", format(e.value), e.pdfBsdf);
        case PathEventKind::Roulette:
            return fmt::format("  roulette: {} with probability {:.4f}\n", e.flag ? "goes on" : "ends",
                               e.weight);
        case PathEventKind::End:
            return fmt::format("radiance {}: {}\n", format(e.value), faultName(e.fault));
    }
    return {};
}

}  // namespace

PathReplay replayPath(const SceneView& view, FeatureMask features, const PassParams& params, int x, int y) {
    return chooseVariant(kernelVariants(), features, params.sampler).replayPixel(view, params, x, y);
}

std::string formatPathLog(const PathReplay& replay, const PassParams& params, int x, int y) {
    std::string text = fmt::format("pixel {},{} pass {} seed {}\n", x, y, params.pass, params.seed);
    bool faultNamed = false;
    for (const PathEvent& event : replay.events) {
        text += formatEvent(event);
        const bool faulty = isFaulty(event.value) || isFaulty(event.throughput);
        if (!faulty || faultNamed || event.kind == PathEventKind::End) { continue; }
        text += "  ^^^ the first value that is not finite or is negative\n";
        faultNamed = true;
    }
    return text;
}

}  // namespace glint
