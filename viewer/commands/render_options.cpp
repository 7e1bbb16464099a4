// Names are ours (tables below), ranges CLI11's.
#include "viewer/commands/render_options.h"

#include <array>
#include <charconv>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "engine/base/nearest_name.h"
#include "engine/build/scene_validation.h"
#include "viewer/commands/json_output.h"
#include "viewer/commands/option_checks.h"

namespace glint {
namespace {

struct NamedAov {
    std::string_view name;
    uint32_t bit;
};
constexpr std::array<NamedAov, 6> kAovs{{{"albedo", kAovAlbedo},
                                         {"normal", kAovShadingNormal},
                                         {"geometric-normal", kAovGeometricNormal},
                                         {"depth", kAovDepth},
                                         {"object-id", kAovObjectId},
                                         {"material-id", kAovMaterialId}}};
constexpr std::string_view kStandardError = "standard-error";

void addLimits(CLI::App& command, RenderCommandOptions* o) {
    command
        .add_option(
            "--passes", o->limits.passes,
            fmt::format("Stop after N passes (samples per pixel); {} without any limit", kDefaultPasses))
        ->check(aboveZero())
        ->type_name("N")
        ->group("When to stop");
    command.add_option("--time", o->limits.renderSeconds, "Stop after SECONDS of rendering")
        ->check(aboveZero())
        ->type_name("SECONDS")
        ->group("When to stop");
    command.add_option("--error", o->limits.relativeError, "Stop at this relative error, such as 0.01")
        ->check(aboveZero())
        ->type_name("E")
        ->group("When to stop");
}

void addSettings(CLI::App& command, RenderCommandOptions* o) {
    const std::string group = "Instead of the scene's own settings";
    command.add_option("--size", o->size, "Picture size in pixels")->type_name("WxH")->group(group);
    command.add_option("--seed", o->seed, "Seed of the random numbers")->group(group);
    command.add_option("--depth", o->depth, "Most scattering events along a path")
        ->check(CLI::Range(0, 1 << 20))
        ->group(group);
    command.add_option("--filter", o->filter, "Reconstruction filter")
        ->check(CLI::IsMember({"box", "gaussian", "blackman-harris"}))
        ->group(group);
    command.add_option("--filter-radius", o->filterRadius, "Half the filter's width in pixels")
        ->check(between(0.001, 16.0))
        ->group(group);
    command.add_option("--sampler", o->sampler, "Points: sobol (low discrepancy) or independent")
        ->check(CLI::IsMember({"sobol", "independent"}))
        ->group(group);
    command.add_option("--camera-position", o->cameraPosition, "Where the camera stands, metres")
        ->type_name("X,Y,Z")
        ->delimiter(',')
        ->expected(3)
        ->group(group);
    command.add_option("--camera-target", o->cameraTarget, "What it looks at")
        ->type_name("X,Y,Z")
        ->delimiter(',')
        ->expected(3)
        ->group(group);
    command.add_option("--fov", o->fov, "Vertical field of view, degrees")
        ->check(between(0.001, 179.9))
        ->group(group);
    command.add_option("--aperture", o->aperture, "Aperture diameter, metres; 0: a pinhole")
        ->check(between(0.0, 1e30))
        ->group(group);
    command.add_option("--focus", o->focus, "Focal distance, metres")->check(aboveZero())->group(group);
}

void addPictureOptions(CLI::App& command, RenderCommandOptions* o) {
    const std::string group = "The picture";
    command.add_option("-o,--output", o->output, "Picture to write: .png, .exr or .hdr")
        ->type_name("OUT")
        ->group(group);
    command.add_option("--exposure", o->exposure, "PNG: exposure in stops")
        ->check(between(-100.0, 100.0))
        ->group(group);
    command.add_option("--tone", o->tone, "PNG: tone map")
        ->check(CLI::IsMember({"clamp", "srgb", "filmic", "reinhard"}))
        ->group(group);
    command
        .add_option("--aov", o->aovs,
                    "EXR: more layers: albedo, normal, geometric-normal, depth, object-id, material-id, "
                    "standard-error")
        ->type_name("NAME,...")
        ->delimiter(',')
        ->group(group);
    command.add_flag("--exr-float", o->exrFloat, "EXR: 32-bit instead of 16-bit colours")->group(group);
}

void addCheckpointOptions(CLI::App& command, RenderCommandOptions* o) {
    const std::string group = "Going on later";
    command.add_option("--checkpoint", o->checkpoint, "Save the film here, at the end and when interrupted")
        ->type_name("FILE")
        ->group(group);
    command.add_option("--checkpoint-every", o->checkpointEvery, "and also every SECONDS")
        ->check(aboveZero())
        ->type_name("SECONDS")
        ->group(group);
    command.add_option("--resume", o->resume, "Go on from this checkpoint, bit for bit")
        ->type_name("FILE")
        ->group(group);
}

void setVec3(const std::vector<float>& values, Vec3* target) {
    if (values.size() == 3) {
        *target = Vec3(values[0], values[1], values[2]);
    }
}

}  // namespace

void addRenderOptions(CLI::App& command, RenderCommandOptions* o) {
    command.add_option("scene", o->scene, "The scene: Glint JSON, 6.837 text, OBJ or PLY")
        ->required()
        ->type_name("SCENE");
    addPictureOptions(command, o);
    addLimits(command, o);
    addSettings(command, o);
    addCheckpointOptions(command, o);
    command.add_flag("--allow-missing", o->allowMissing,
                     "Render what can be rendered when parts of the scene are missing");
    command.add_option("--threads", o->threads, "Render threads; all by default")->check(CLI::Range(1, 1024));
    command.add_option("--backend", o->backend, "cpu or cuda");
    command
        .add_option("--pixel", o->pixel,
                    "Print the path of pixel x,y in the pass given by --pass instead of rendering")
        ->type_name("X,Y")
        ->group("Looking into one path");
    command.add_option("--pass", o->replayPass, "which pass, counted from 0")
        ->type_name("N")
        ->group("Looking into one path");
    addJsonOption(command, &o->json);
}

Result<Vec2i> parsePair(const std::string& text, char separator, const char* what) {
    const size_t middle = text.find(separator);
    Vec2i pair(0);
    const auto read = [](std::string_view part, int* out) {
        const auto [end, problem] = std::from_chars(part.data(), part.data() + part.size(), *out);
        return problem == std::errc() && end == part.data() + part.size();
    };
    const std::string_view all = text;
    if (middle == std::string::npos || !read(all.substr(0, middle), &pair.x) ||
        !read(all.substr(middle + 1), &pair.y)) {
        return Error{
            fmt::format("{} is '{}'; expected two whole numbers such as 640{}480", what, text, separator),
            {}};
    }
    return pair;
}

Status applyTo(const RenderCommandOptions& o, SceneDescription* scene) {
    if (!o.size.empty()) {
        const Result<Vec2i> size = parsePair(o.size, 'x', "--size");
        if (!size) {
            return size.error();
        }
        if (size->x < 1 || size->y < 1 || size->x > kMaxResolution || size->y > kMaxResolution) {
            return Error{
                fmt::format("--size is {}; expected 1 to {} pixels each way", o.size, kMaxResolution), {}};
        }
        scene->resolution = {size->x, size->y};
    }
    RenderOptions& options = scene->options;
    options.seed = o.seed.value_or(options.seed);
    options.maxDepth = o.depth.value_or(options.maxDepth);
    if (!o.filter.empty()) {
        options.filter = o.filter == "box"        ? FilterKind::Box
                         : o.filter == "gaussian" ? FilterKind::Gaussian
                                                  : FilterKind::BlackmanHarris;
        options.filterRadius = o.filter == "box" ? 0.5f : 1.5f;
    }
    options.filterRadius = o.filterRadius.value_or(options.filterRadius);
    if (!o.sampler.empty()) {
        options.sampler = o.sampler == "sobol" ? SamplerKind::Sobol : SamplerKind::Independent;
    }
    Camera& camera = scene->camera;
    setVec3(o.cameraPosition, &camera.position);
    setVec3(o.cameraTarget, &camera.target);
    camera.verticalFovDeg = o.fov.value_or(camera.verticalFovDeg);
    camera.apertureDiameter = o.aperture.value_or(camera.apertureDiameter);
    camera.focalDistance = o.focus.value_or(camera.focalDistance);
    return {};
}

Result<AovChoice> chooseAovs(const std::vector<std::string>& names) {
    std::vector<std::string_view> known{kStandardError};
    for (const NamedAov& aov : kAovs) {
        known.push_back(aov.name);
    }
    AovChoice choice;
    for (const std::string& name : names) {
        const auto* found =
            std::find_if(kAovs.begin(), kAovs.end(), [&](const NamedAov& aov) { return aov.name == name; });
        if (found != kAovs.end()) {
            choice.aovs |= found->bit;
        } else if (name == kStandardError) {
            choice.standardError = true;
        } else {
            return Error{fmt::format("--aov: there is no '{}'{}", name, didYouMean(name, known)), {}};
        }
    }
    return choice;
}

}  // namespace glint
