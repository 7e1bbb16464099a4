#include "viewer/commands/render_options.h"

#include <array>
#include <charconv>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "engine/base/nearest_name.h"
#include "engine/builders/scene_validation.h"
#include "engine/io/image_formats.h"
#include "engine/io/importer.h"
#include "viewer/commands/command_line.h"
#include "viewer/commands/json_output.h"

namespace glint {
namespace {

constexpr const char* kSettingsGroup = "Instead of the scene's own settings";

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
constexpr std::string_view kBias = "bias";
constexpr std::string_view kErrorBound = "error-bound";

void addLimits(const Command& command, RenderCommandOptions* o) {
    command
        .option("--passes", &o->limits.passes,
                fmt::format("Stop after N passes (samples per pixel); {} without any limit", kDefaultPasses))
        .aboveZero()
        .typeName("N")
        .group("When to stop");
    command.option("--time", &o->limits.renderSeconds, "Stop after SECONDS of rendering")
        .aboveZero()
        .typeName("SECONDS")
        .group("When to stop");
    command
        .option("--error", &o->limits.relativeError,
                "Stop when the error is below E with 95 %; relative, such as 0.01")
        .aboveZero()
        .typeName("E")
        .group("When to stop");
}

void addSettings(const Command& command, RenderCommandOptions* o) {
    const std::string group = kSettingsGroup;
    command.option("--size", &o->size, "Picture size in pixels").typeName("WxH").group(group);
    command.option("--seed", &o->seed, "Seed of the random numbers").group(group);
    command.option("--depth", &o->depth, "Most scattering events along a path")
        .range(0, 1 << 20)
        .group(group);
    command.option("--filter", &o->filter, "Reconstruction filter")
        .oneOf({"box", "gaussian", "blackman-harris"})
        .group(group);
    command.option("--filter-radius", &o->filterRadius, "Half the filter's width in pixels")
        .between(0.001, 16.0)
        .group(group);
    command.option("--sampler", &o->sampler, "Points: sobol (low discrepancy) or independent")
        .oneOf({"sobol", "independent"})
        .group(group);
    command.option("--camera-position", &o->cameraPosition, "Where the camera stands, metres")
        .typeName("X,Y,Z")
        .commaSeparated(3, 3)
        .group(group);
    command.option("--camera-target", &o->cameraTarget, "What it looks at")
        .typeName("X,Y,Z")
        .commaSeparated(3, 3)
        .group(group);
    command.option("--fov", &o->fov, "Vertical field of view, degrees").between(0.001, 179.9).group(group);
    command.option("--aperture", &o->aperture, "Aperture diameter, metres; 0: a pinhole")
        .between(0.0, 1e30)
        .group(group);
    command.option("--focus", &o->focus, "Focal distance, metres").aboveZero().group(group);
}

/// Keys and short names, and "key: display name; ..." for the help.
std::vector<std::string> integratorChoices() {
    const std::vector<std::string_view> names = integratorNames();
    return {names.begin(), names.end()};
}

std::string integratorHelp() {
    std::string help;
    for (const IntegratorInfo& info : kIntegratorTable) {
        help += fmt::format("{}{}: {}", help.empty() ? "" : "; ", info.key, info.displayName);
    }
    return help;
}

void addPhotonOptions(const Command& command, RenderCommandOptions* o) {
    const std::string group = "Photon mapping, instead of the scene's own settings";
    command.option("--integrator", &o->integrator, integratorHelp()).oneOf(integratorChoices()).group(group);
    command.option("--photons", &o->photons, "Photons in a pass")
        .range(1u, 1u << 30)
        .typeName("N")
        .group(group);
    command.option("--radius", &o->radius, "First radius: metres, or auto:K for K pixel footprints")
        .typeName("R|auto:K")
        .group(group);
    command.option("--alpha", &o->alpha, "Share of each pass's photons that is kept, between 0 and 1")
        .typeName("A")
        .group(group);
    command.option("--direct", &o->direct, "Direct light: sampled, or left to the photons")
        .oneOf({"sampled", "photons"})
        .group(group);
    command.option("--lookup", &o->lookup, "How photons are found").oneOf({"grid", "tree"}).group(group);
    command.option("--memory", &o->memoryMiB, "Budget for photons and statistics; 0: no limit")
        .range(0u, 1u << 22)
        .typeName("MiB")
        .group(group);
}

void addImageOptions(const Command& command, RenderCommandOptions* o) {
    const std::string group = "The picture";
    command.option("-o,--output", &o->output, "Picture to write: " + listSavedExtensions())
        .typeName("OUT")
        .group(group);
    command.option("--exposure", &o->exposure, "PNG: exposure in stops").between(-100.0, 100.0).group(group);
    command.option("--tone", &o->tone, "PNG: tone map")
        .oneOf({"clamp", "srgb", "filmic", "reinhard"})
        .group(group);
    command
        .option("--aov", &o->aovs,
                "EXR: more layers: albedo, normal, geometric-normal, depth, object-id, material-id, "
                "standard-error, bias, error-bound")
        .typeName("NAME,...")
        .commaSeparated()
        .group(group);
    command.flag("--exr-float", &o->exrFloat, "EXR: 32-bit instead of 16-bit colours").group(group);
}

void addCheckpointOptions(const Command& command, RenderCommandOptions* o) {
    const std::string group = "Going on later";
    command.option("--checkpoint", &o->checkpoint, "Save the film here, at the end and when interrupted")
        .typeName("FILE")
        .group(group);
    command
        .option("--checkpoint-every", &o->checkpointEvery,
                "N: every N passes write a numbered picture (OUT-000050.png), and the checkpoint where one "
                "is named; Ts: the checkpoint every T seconds")
        .typeName("N|Ts")
        .group(group);
    command.option("--resume", &o->resume, "Go on from this checkpoint, bit for bit")
        .typeName("FILE")
        .group(group);
}

/// Metres, "auto", or "auto:K".
Status applyRadius(const std::string& text, SppmOptions* sppm) {
    const bool automatic = text.starts_with("auto");
    const std::string_view rest = std::string_view(text).substr(automatic ? 4 : 0);
    if (automatic) { sppm->radiusWorld = 0.0f; }
    if (automatic && rest.empty()) { return {}; }
    const std::string_view digits = automatic && rest.starts_with(':') ? rest.substr(1) : rest;
    float value = 0.0f;
    const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (problem != std::errc() || end != digits.data() + digits.size() || !(value > 0.0f) ||
        automatic == (digits.size() == rest.size())) {
        return Error{fmt::format("--radius is '{}'; expected metres such as 0.05, auto, or auto:K such as "
                                 "auto:4 for pixel footprints",
                                 text),
                     {}};
    }
    (automatic ? sppm->radiusFootprints : sppm->radiusWorld) = value;
    return {};
}

Status applyPhotons(const RenderCommandOptions& o, SceneDescription* scene) {
    scene->options.integrator = integratorByName(o.integrator).value_or(scene->options.integrator);
    const bool any =
        o.photons || !o.radius.empty() || o.alpha || !o.direct.empty() || !o.lookup.empty() || o.memoryMiB;
    if (any && scene->options.integrator != IntegratorKind::Sppm) {
        return Error{
            "--photons, --radius, --alpha, --direct, --lookup and --memory are for photon mapping; add "
            "--integrator sppm",
            {}};
    }
    SppmOptions& sppm = scene->sppm;
    sppm.photonsPerPass = o.photons.value_or(sppm.photonsPerPass);
    sppm.alpha = o.alpha.value_or(sppm.alpha);
    sppm.memoryBudgetMiB = o.memoryMiB.value_or(sppm.memoryBudgetMiB);
    if (!(sppm.alpha > 0.0f && sppm.alpha < 1.0f)) {
        return Error{fmt::format("--alpha is {}; expected a number between 0 and 1", sppm.alpha), {}};
    }
    if (!o.direct.empty()) { sppm.sampleDirectLight = o.direct == "sampled"; }
    if (!o.lookup.empty()) {
        sppm.lookup = o.lookup == "tree" ? PhotonLookupKind::Tree : PhotonLookupKind::Grid;
    }
    return o.radius.empty() ? Status() : applyRadius(o.radius, &sppm);
}

void setVec3(const std::vector<float>& values, Vec3* target) {
    if (values.size() == 3) { *target = Vec3(values[0], values[1], values[2]); }
}

}  // namespace

std::string quotedForShell(const std::string& word) {
    constexpr std::string_view kPlain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_.,:/+=@%";
    if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) { return word; }
    std::string quoted = "'";
    for (const char c : word) {
        quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return quoted + "'";
}

std::string sceneOptionsAsWritten(const Command& command) {
    std::string all;
    for (const GivenOption& option : command.given()) {
        if (option.group == kSettingsGroup) {
            all += fmt::format(" {} {}", option.name, quotedForShell(option.value));
        }
    }
    return all;
}

void addRenderOptions(const Command& command, RenderCommandOptions* o) {
    command.option("scene", &o->scene, "The scene: " + listImporters()).required().typeName("SCENE");
    addImageOptions(command, o);
    addLimits(command, o);
    addSettings(command, o);
    addPhotonOptions(command, o);
    addCheckpointOptions(command, o);
    command.flag("--allow-missing", &o->allowMissing,
                 "Render what can be rendered when parts of the scene are missing");
    command.option("--threads", &o->threads, "Render threads; all by default").range(1, 1024);
    command.option("--backend", &o->backend, "cpu or cuda");
    command
        .option("--pixel", &o->pixel,
                "Print the path of pixel x,y in the pass given by --pass instead of rendering")
        .typeName("X,Y")
        .group("Looking into one path");
    command.option("--pass", &o->replayPass, "which pass, counted from 0")
        .typeName("N")
        .group("Looking into one path");
    addJsonOption(command, &o->json);
}

Result<SaveInterval> parseSaveInterval(const std::string& text) {
    if (text.empty()) { return SaveInterval{}; }
    const bool bySeconds = text.back() == 's';
    const char* end = text.data() + text.size() - (bySeconds ? 1 : 0);
    SaveInterval interval;
    const auto [last, problem] = bySeconds ? std::from_chars(text.data(), end, interval.seconds)
                                           : std::from_chars(text.data(), end, interval.passes);
    const bool positive = interval.passes > 0 || (interval.seconds > 0.0 && interval.seconds <= 1e9);
    if (problem != std::errc() || last != end || !positive) {
        return Error{
            fmt::format("--checkpoint-every is '{}'; expected passes such as 50, or seconds such as 60s",
                        text),
            {}};
    }
    return interval;
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
        if (!size) { return size.error(); }
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
    return applyPhotons(o, scene);
}

Result<AovChoice> chooseAovs(const std::vector<std::string>& names) {
    std::vector<std::string_view> known{kStandardError, kBias, kErrorBound};
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
        } else if (name == kBias || name == kErrorBound) {
            choice.errorMaps = true;
        } else {
            return Error{fmt::format("--aov: there is no '{}'{}", name, didYouMean(name, known)), {}};
        }
    }
    return choice;
}

}  // namespace glint
