// `glint diff`: how far a picture is from a reference, in numbers, in maps, and as an exit code for scripts.
//
// The metrics are engine/report's. Pictures of different kinds are compared as linear colours: PNG and its
// like are decoded from sRGB.
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/base/console.h"
#include "engine/base/log.h"
#include "engine/io/image_io.h"
#include "engine/report/metric_table.h"
#include "viewer/commands/command_line.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/diff_maps.h"
#include "viewer/commands/json_output.h"

namespace glint {
namespace {

constexpr const char* kDiffFooter =
    R"(Both are compared as linear Rec.709 colours: EXR, HDR and floats in TIFF as stored, all others decoded from sRGB.
An 8-bit picture holds nothing above 1, so beside an EXR that does, its lamps and highlights count as errors.
With t the picture, r the reference, and means over all pixels and channels:
  picture error  what glint render and the window show and stop by: root of the mean over pixels of the squared error of
                 the luminance, relative to its own and a tenth of the typical one, 1 at most, without the worst 0.1 %
  MSE            mean of (t - r)^2; RMSE is its square root
  relMSE         mean of (t - r)^2 / (r^2 + epsilon); relative RMSE is its square root; trimmed: without the
                 worst pixels
  MAPE           mean of |t - r| / (|r| + epsilon)
  bias           mean of t - r; relative bias: over the mean of r
  SSIM           structural similarity of the luminance as shown on a screen (Wang et al. 2004); 1 is equal
  FLIP           the difference a viewer sees (Andersson et al. 2020, LDR-FLIP as sRGB clipped at --exposure)
  HDR-FLIP       the same at the worst of a range of exposures (Andersson et al. 2021)
--maps writes relative-squared.png, absolute.png, signed.png and flip.png, each with a legend. Maps of several pictures
can be compared when they span one range: --map-range absolute=0.001:1 --map-range signed=0.2. FLIP spans 0 to 1.

Exit codes: 0 within all limits, 1 the input or the options are wrong, 2 a file cannot be written,
3 the pictures differ by more than a limit allows.)";

struct DiffOptions {
    std::string test, reference;
    MetricOptions metrics;
    std::map<std::string, double> limits;  ///< by the metric's key
    std::string maps;
    MapRanges ranges;
    std::string json;
};

/// A picture and whether its file has 8 bits a channel.
struct LoadedImage {
    std::shared_ptr<const ImageF> colors;
    bool eightBits = false;
};

Result<LoadedImage> loadRgbImage(const std::string& path) {
    const Result<SceneImage> image = loadImage(path);
    if (!image) { return image.error(); }
    return LoadedImage{linearColors(*image), image->bytes != nullptr};
}

/// What 8 bits lack beside a picture of floats; nothing where both are of one kind.
std::vector<std::string> kindWarnings(const DiffOptions& options, const LoadedImage& test,
                                      const LoadedImage& reference) {
    if (test.eightBits == reference.eightBits) { return {}; }
    const ImageF& floats = test.eightBits ? *reference.colors : *test.colors;
    const auto brighter = std::ranges::count_if(floats.rgb, [](float value) { return value > 1.0f; });
    const std::string& bytesFile = test.eightBits ? options.test : options.reference;
    const std::string& floatsFile = test.eightBits ? options.reference : options.test;
    return {fmt::format(
        "{} has 8 bits a channel and {} has floats: values above 1 ({} of {} here) and a rounding "
        "of up to half of 1/255 count as errors, and so does any exposure or tone curve",
        bytesFile, floatsFile, brighter, floats.rgb.size())};
}

bool isWithin(const MetricInfo& metric, double value, double limit) {
    return metric.largerIsBetter ? value >= limit : (metric.isSigned ? std::abs(value) : value) <= limit;
}

/// "--max-relmse", "--min-ssim".
std::string limitOption(const MetricInfo& metric) {
    return fmt::format("--{}-{}", metric.largerIsBetter ? "min" : "max", metric.option);
}

void printMetrics(const DiffOptions& options, const ImageMetrics& metrics, const ImageF& image) {
    put("{} against the reference {}\n", options.test, options.reference);
    put("{}x{} pixels", image.width, image.height);
    if (metrics.trimmedPixels > 0) {
        put("; the worst {} left out of relMSE trimmed", metrics.trimmedPixels);
    }
    if (metrics.whollyWrongPixels > 0) { put("; {} wholly wrong", metrics.whollyWrongPixels); }
    put("\n");
    for (const MetricInfo& metric : metricTable()) {
        const double value = metric.value(metrics);
        if (std::isnan(value)) {
            continue;  // not asked for
        }
        const bool hasMeaning = std::isfinite(value);
        std::string note = hasMeaning ? "" : "the reference is black";
        if (&metric == findMetric("max_error") && metrics.maxError > 0.0) {
            note = fmt::format("in column {}, row {}", metrics.maxErrorX, metrics.maxErrorY);
        }
        if (const auto limit = options.limits.find(metric.key); limit != options.limits.end()) {
            const bool within = isWithin(metric, value, limit->second);
            note += fmt::format("{}{} {:g}: {}", note.empty() ? "" : "; ", limitOption(metric), limit->second,
                                within ? "within" : "BEYOND");
        }
        const std::string line = fmt::format("  {:<16}{:<14}{}", metric.name,
                                             hasMeaning ? fmt::format("{:.6g}", value) : "none", note);
        put("{}\n", line.substr(0, line.find_last_not_of(' ') + 1));
    }
}

nlohmann::ordered_json mapsJson(const std::vector<WrittenMap>& maps) {
    nlohmann::ordered_json out = nlohmann::ordered_json::array();
    for (const WrittenMap& map : maps) {
        out.push_back({{"map", errorMapName(map.kind)},
                       {"file", map.file},
                       {"low", map.range.low},
                       {"high", map.range.high},
                       {"logarithmic", map.range.logarithmic}});
    }
    return out;
}

void printMaps(const std::vector<WrittenMap>& maps) {
    for (const WrittenMap& map : maps) {
        put("{}: colours from {:g} to {:g}{}\n", map.file, map.range.low, map.range.high,
            map.range.logarithmic ? ", logarithmic" : "");
    }
}

nlohmann::ordered_json jsonReport(const DiffOptions& options, const ImageMetrics& metrics,
                                  const ImageF& image, bool within) {
    nlohmann::ordered_json values, limits = nlohmann::ordered_json::array();
    for (const MetricInfo& metric : metricTable()) {
        const double value = metric.value(metrics);
        values[metric.key] = value;
        if (const auto limit = options.limits.find(metric.key); limit != options.limits.end()) {
            limits.push_back({{"metric", metric.key},
                              {"limit", limit->second},
                              {"within", isWithin(metric, value, limit->second)}});
        }
    }
    return {{"picture", options.test},
            {"reference", options.reference},
            {"width", image.width},
            {"height", image.height},
            {"metrics", values},
            {"max_error_pixel", {metrics.maxErrorX, metrics.maxErrorY}},
            {"trimmed_pixels", metrics.trimmedPixels},
            {"wholly_wrong_pixels", metrics.whollyWrongPixels},
            {"epsilon", options.metrics.relativeEpsilon},
            {"exposure_stops", options.metrics.exposureStops},
            {"pixels_per_degree", options.metrics.pixelsPerDegree},
            {"limits", limits},
            {"within_limits", within}};
}

bool allWithin(const DiffOptions& options, const ImageMetrics& metrics) {
    bool within = true;
    for (const auto& [key, limit] : options.limits) {
        const MetricInfo& metric = *findMetric(key);
        within = isWithin(metric, metric.value(metrics), limit) && within;
    }
    return within;
}

/// Prints and writes everything; the maps after the numbers, which must not be lost with them.
Status report(const DiffOptions& options, const ImageMetrics& metrics, const ImageF& test,
              const ImageF& reference, const std::vector<std::string>& warnings) {
    const bool printed = !jsonTakesOutput(options.json);
    if (printed) { printMetrics(options, metrics, test); }
    Result<std::vector<WrittenMap>> maps = std::vector<WrittenMap>();
    if (!options.maps.empty()) {
        maps = writeMaps(options.maps, options.ranges, test, reference, options.metrics);
    }
    if (printed && maps) { printMaps(*maps); }
    nlohmann::ordered_json json = jsonReport(options, metrics, test, allWithin(options, metrics));
    json["maps"] = mapsJson(maps ? *maps : std::vector<WrittenMap>());
    json["warnings"] = warnings;
    const Status written = writeJson(options.json, "diff", json);
    return maps ? written : Status(maps.error());
}

Status checkOutputs(const DiffOptions& options) {
    RunFiles files;
    files.reads("the picture in question", options.test);
    files.reads("the reference", options.reference);
    const Status json = files.writes(options.json);
    return json && !options.maps.empty() ? prepareMapFolder(options.maps, &files) : json;
}

int runDiff(const DiffOptions& options) {
    const auto test = loadRgbImage(options.test);
    if (!test) { return reportError(test.error(), kExitBadInput); }
    const auto reference = loadRgbImage(options.reference);
    if (!reference) { return reportError(reference.error(), kExitBadInput); }
    const Result<ImageMetrics> metrics = compareImages(*test->colors, *reference->colors, options.metrics);
    if (!metrics) { return reportError(metrics.error(), kExitBadInput); }
    if (const Status outputs = checkOutputs(options); !outputs) {
        return reportError(outputs.error(), kExitBadInput);
    }
    const std::vector<std::string> warnings = kindWarnings(options, *test, *reference);
    for (const std::string& warning : warnings) {
        logWarning("{}", warning);
    }
    const Status written = report(options, *metrics, *test->colors, *reference->colors, warnings);
    if (!written) { return reportError(written.error(), kExitFailed); }
    return allWithin(options, *metrics) ? kExitDone : kExitBeyondLimit;
}

void addLimitOptions(const Command& command, DiffOptions* options) {
    for (const MetricInfo& metric : metricTable()) {
        const std::string text =
            metric.largerIsBetter ? fmt::format("Exit code 3 when {} is below this", metric.name)
            : metric.isSigned
                ? fmt::format("Exit code 3 when the {} is larger than this either way", metric.name)
                : fmt::format("Exit code 3 when {} is above this", metric.name);
        const auto limit = [options, &metric](double value) {
            options->limits[metric.key] = value;
            options->metrics.hdrFlip = options->metrics.hdrFlip || &metric == findMetric("hdr_flip");
        };
        command.optionNumber(limitOption(metric), limit, text)
            .typeName("X")
            .between(metric.largerIsBetter ? -1.0 : 0.0, metric.largerIsBetter ? 1.0 : 1e300)
            .group("Limits");
    }
}

}  // namespace

void addDiffCommand(const Command& program) {
    const Command command = program.subcommand("diff", "How far a picture is from a reference");
    const auto options = std::make_shared<DiffOptions>();
    command.option("picture", &options->test, "The picture in question").required().typeName("A");
    command.option("reference", &options->reference, "What it should be").required().typeName("B");
    command.option("--maps", &options->maps, "Write error maps in false colours into the folder DIR")
        .typeName("DIR");
    command
        .optionEach(
            "--map-range",
            [options](const std::string& range) { return addMapRange(range, &options->ranges); },
            "What a map's colours span, so that several maps can be compared: absolute=LOW:HIGH, "
            "relative-squared=LOW:HIGH or signed=LIMIT; chosen from the picture by default")
        .typeName("MAP=RANGE")
        .oneValueEach()
        .needs("--maps");
    addJsonOption(command, &options->json);
    MetricOptions& metrics = options->metrics;
    command.option("--epsilon", &metrics.relativeEpsilon, "Added to the denominators of relative errors")
        .typeName("X")
        .aboveZero()
        .showDefault();
    command
        .option("--trim", &metrics.trimmedShare, "Share of the worst pixels that relMSE trimmed leaves out")
        .typeName("SHARE")
        .between(0.0, 0.999)
        .showDefault();
    command.option("--exposure", &metrics.exposureStops, "Stops, for SSIM and FLIP only")
        .typeName("STOPS")
        .between(-60.0, 60.0)
        .showDefault();
    command.option("--pixels-per-degree", &metrics.pixelsPerDegree, "Of the viewer's visual angle, for FLIP")
        .typeName("N")
        .between(1.0, 1000.0)
        .showDefault();
    command.flag("--hdr-flip", &metrics.hdrFlip,
                 "Also HDR-FLIP, over a range of exposures; takes several times as long");
    command.option("--threads", &metrics.threads, "Default: all").typeName("N").range(1, 1024);
    addLimitOptions(command, options.get());
    command.footer(kDiffFooter);
    command.onRun([options] { return runDiff(*options); });
}

}  // namespace glint
