#include "viewer/commands/render_options.h"

#include <array>
#include <charconv>

#include <fmt/format.h>

#include "engine/base/nearest_name.h"
#include "engine/io/image_formats.h"
#include "engine/io/importer.h"
#include "viewer/commands/command_line.h"
#include "viewer/commands/json_output.h"

namespace glint {
namespace {

struct NamedAov {
    std::string_view name;
    uint32_t bit;
};
constexpr std::array<NamedAov, 9> kAovs{{{"albedo", kAovAlbedo},
                                         {"normal", kAovShadingNormal},
                                         {"geometric-normal", kAovGeometricNormal},
                                         {"depth", kAovDepth},
                                         {"object-id", kAovObjectId},
                                         {"material-id", kAovMaterialId},
                                         {"boxes-tested", kAovBoxesTested},
                                         {"triangles-tested", kAovPrimitivesTested},
                                         {"newton-steps", kAovNewtonSteps}}};
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

void addImageOptions(const Command& command, RenderCommandOptions* o) {
    const std::string group = "The picture";
    command.option("-o,--output", &o->output, "Picture to write: " + listSavedExtensions())
        .typeName("OUT")
        .group(group);
    command
        .option("--exposure", &o->exposure,
                "PNG: exposure in stops; by default 0, or what a picture needs that would be black or white")
        .between(-100.0, 100.0)
        .group(group);
    command
        .flag("--no-auto-exposure", &o->noAutoExposure, "PNG: exposure 0 also where that is black or white")
        .group(group);
    command.option("--tone", &o->tone, "PNG: tone map, srgb by default")
        .oneOf({"clamp", "srgb", "filmic", "reinhard", "soft"})
        .group(group);
    command
        .option("--ocio", &o->ocio,
                "PNG: a view of an OpenColorIO configuration in place of the tone map, by default its first")
        .typeName("CONFIG[:DISPLAY[/VIEW]]")
        .excludes("--tone")
        .group(group);
    command
        .option(
            "--white-balance", &o->white.kelvin,
            "PNG: temperature of the light that is shown white, in K; by default 6504, which changes nothing")
        .between(kLeastKelvin, kMostKelvin)
        .typeName("K")
        .group(group);
    command.option("--tint", &o->white.tint, "PNG: above 0 takes green out of the white, below 0 adds it")
        .between(-kMostTint, kMostTint)
        .group(group);
    command
        .flag("--dither", &o->dither,
              "PNG: round to 8 bits by a fine pattern, so that gradients show no steps")
        .group(group);
    command
        .option("--aov", &o->aovs,
                "EXR: more layers: albedo, normal, geometric-normal, depth, object-id, material-id, "
                "boxes-tested, triangles-tested, newton-steps, standard-error, bias, error-bound")
        .typeName("NAME,...")
        .commaSeparated()
        .group(group);
    command
        .flag(
            "--denoise", &o->denoise,
            "Take the noise out of the picture, guided by albedo, normals, depth and the pixels' variances; "
            "checkpoints keep the film as it is")
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
    command
        .flag("--overwrite", &o->overwrite,
              "Let the checkpoint replace a longer one, one of another scene, or another file")
        .group(group);
    command
        .option("--resume", &o->resume,
                "Go on from this checkpoint, bit for bit; the scene is given as before, its -D are kept")
        .typeName("FILE")
        .group(group);
}

void addFrameOptions(const Command& command, RenderCommandOptions* o) {
    const std::string group = "Several pictures (OUT-000001.png ...), each with the limits above";
    command.option("--turntable", &o->turntable, "N pictures of a whole turn around the camera's target")
        .range(1u, 100000u)
        .typeName("N")
        .group(group);
    command
        .option(
            "--flight", &o->flight,
            "N pictures on a smooth way through the views that were bookmarked for the scene in the window")
        .range(2u, 100000u)
        .typeName("N")
        .excludes("--turntable")
        .group(group);
}

}  // namespace

std::optional<float> statedExposure(const RenderCommandOptions& options) {
    const bool isZero = options.noAutoExposure || options.overrides.asOriginal;
    return options.exposure || !isZero ? options.exposure : std::optional(0.0f);
}

ToneMap toneMapOf(const RenderCommandOptions& options) {
    return toneMapFromName(options.tone)
        .value_or(options.overrides.asOriginal ? ToneMap::Clamp : ToneMap::Srgb);
}

StopLimits finalLimits(const RenderCommandOptions& options) {
    return options.limits == StopLimits{} ? StopLimits{.passes = kDefaultPasses} : options.limits;
}

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

void addRenderOptions(const Command& command, RenderCommandOptions* o) {
    command.option("scene", &o->scene, "The scene: " + listImporters()).required().typeName("SCENE");
    addImageOptions(command, o);
    addLimits(command, o);
    addSceneOverrides(command, &o->overrides);
    addCheckpointOptions(command, o);
    addFrameOptions(command, o);
    addLoadOptions(command, &o->load);
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
