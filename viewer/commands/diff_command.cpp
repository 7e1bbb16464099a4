// `glint diff`: how far a picture is from a reference, in numbers, in maps, and as an exit code for scripts.
//
// The metrics are engine/report's. Pictures of different kinds are compared as linear colours: PNG and its
// like are decoded from sRGB.
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/io/image_io.h"
#include "engine/report/error_maps.h"
#include "engine/report/map_legend.h"
#include "engine/report/metric_table.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/json_output.h"
#include "viewer/commands/option_checks.h"
#include "viewer/commands/output_files.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFooter =
    R"(Both are compared as linear Rec.709 colours: EXR and HDR as stored, PNG, JPEG, BMP and TGA decoded from sRGB.
An 8-bit picture holds nothing above 1, so beside an EXR that does, its lamps and highlights count as errors.
With t the picture, r the reference, and means over all pixels and channels:
  MSE            mean of (t - r)^2; RMSE is its square root
  relMSE         mean of (t - r)^2 / (r^2 + epsilon); relative RMSE is its square root; trimmed: without the
                 worst pixels
  MAPE           mean of |t - r| / (|r| + epsilon)
  bias           mean of t - r; relative bias: over the mean of r
  SSIM           structural similarity of the luminance as shown on a screen (Wang et al. 2004); 1 is equal
  FLIP           the difference a viewer sees (Andersson et al. 2020, LDR-FLIP as sRGB clipped at --exposure)
  HDR-FLIP       the same at the worst of a range of exposures (Andersson et al. 2021)
--maps writes relative-squared.png, absolute.png, signed.png and flip.png, each with a legend.

Exit codes: 0 within all limits, 1 the input or the options are wrong, 2 a file cannot be written,
3 the pictures differ by more than a limit allows.)";

struct DiffOptions {
    std::string test, reference;
    MetricOptions metrics;
    std::map<std::string, double> limits;  ///< by the metric's key
    std::string maps;
    std::string json;
};

bool isWithin(const MetricInfo& metric, double value, double limit) {
    return metric.largerIsBetter ? value >= limit : (metric.isSigned ? std::abs(value) : value) <= limit;
}

/// "--max-relmse", "--min-ssim".
std::string limitOption(const MetricInfo& metric) {
    return fmt::format("--{}-{}", metric.largerIsBetter ? "min" : "max", metric.option);
}

void printMetrics(const DiffOptions& options, const PictureMetrics& metrics, const ImageF& picture) {
    fmt::print("{} against the reference {}\n", options.test, options.reference);
    fmt::print("{}x{} pixels", picture.width, picture.height);
    if (metrics.trimmedPixels > 0) {
        fmt::print("; the worst {} left out of relMSE trimmed", metrics.trimmedPixels);
    }
    fmt::print("\n");
    for (const MetricInfo& metric : metricTable()) {
        const double value = metric.value(metrics);
        if (std::isnan(value)) {
            continue;  // not asked for
        }
        std::string note;
        if (&metric == findMetric("max_error") && metrics.maxError > 0.0) {
            note = fmt::format("in column {}, row {}", metrics.maxErrorX, metrics.maxErrorY);
        }
        if (const auto limit = options.limits.find(metric.key); limit != options.limits.end()) {
            const bool within = isWithin(metric, value, limit->second);
            note += fmt::format("{}{} {:g}: {}", note.empty() ? "" : "; ", limitOption(metric), limit->second,
                                within ? "within" : "BEYOND");
        }
        const std::string line = fmt::format("  {:<16}{:<14.6g}{}", metric.name, value, note);
        fmt::print("{}\n", line.substr(0, line.find_last_not_of(' ') + 1));
    }
}

nlohmann::ordered_json jsonReport(const DiffOptions& options, const PictureMetrics& metrics,
                                  const ImageF& picture, bool within) {
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
            {"width", picture.width},
            {"height", picture.height},
            {"metrics", values},
            {"max_error_pixel", {metrics.maxErrorX, metrics.maxErrorY}},
            {"trimmed_pixels", metrics.trimmedPixels},
            {"epsilon", options.metrics.relativeEpsilon},
            {"exposure_stops", options.metrics.exposureStops},
            {"pixels_per_degree", options.metrics.pixelsPerDegree},
            {"limits", limits},
            {"within_limits", within}};
}

std::string mapPath(const DiffOptions& options, ErrorMapKind kind) {
    return (fs::path(options.maps) / fmt::format("{}.png", errorMapName(kind))).string();
}

/// Makes the folder, so that a wrong name is refused before anything is computed.
Status prepareMaps(const DiffOptions& options) {
    if (options.maps.empty()) {
        return {};
    }
    std::error_code problem;
    fs::create_directories(options.maps, problem);
    if (problem) {
        return Error{fmt::format("--maps {}: cannot make that folder: {}", options.maps, problem.message()),
                     {}};
    }
    return checkWritable(mapPath(options, ErrorMapKind::Flip));
}

Status writeMaps(const DiffOptions& options, const ImageF& test, const ImageF& reference) {
    for (int i = 0; i < kErrorMapKindCount && !options.maps.empty(); ++i) {
        const auto kind = static_cast<ErrorMapKind>(i);
        const Result<ErrorMap> map = errorMap(kind, test, reference, options.metrics);
        if (!map) {
            return map.error();
        }
        if (Status saved = savePng(mapPath(options, kind), mapWithLegend(*map, readableRange(*map)));
            !saved) {
            return saved;
        }
    }
    return {};
}

bool allWithin(const DiffOptions& options, const PictureMetrics& metrics) {
    bool within = true;
    for (const auto& [key, limit] : options.limits) {
        const MetricInfo& metric = *findMetric(key);
        within = isWithin(metric, metric.value(metrics), limit) && within;
    }
    return within;
}

int runDiff(const DiffOptions& options) {
    const auto test = loadImageF(options.test);
    if (!test) {
        return complain(test.error(), kExitBadInput);
    }
    const auto reference = loadImageF(options.reference);
    if (!reference) {
        return complain(reference.error(), kExitBadInput);
    }
    const Result<PictureMetrics> metrics = comparePictures(**test, **reference, options.metrics);
    if (!metrics) {
        return complain(metrics.error(), kExitBadInput);
    }
    if (const Status prepared = prepareMaps(options); !prepared) {
        return complain(prepared.error(), kExitBadInput);
    }
    const bool within = allWithin(options, *metrics);
    if (!jsonTakesOutput(options.json)) {
        printMetrics(options, *metrics, **test);
    }
    Status written = writeJson(options.json, jsonReport(options, *metrics, **test, within));
    if (written) {
        written = writeMaps(options, **test, **reference);
    }
    if (!written) {
        return complain(written.error(), kExitFailed);
    }
    return within ? kExitDone : kExitBeyondLimit;
}

void addLimitOptions(CLI::App* command, DiffOptions* options) {
    for (const MetricInfo& metric : metricTable()) {
        const std::string text =
            metric.largerIsBetter ? fmt::format("Exit code 3 when {} is below this", metric.name)
            : metric.isSigned
                ? fmt::format("Exit code 3 when the {} is larger than this either way", metric.name)
                : fmt::format("Exit code 3 when {} is above this", metric.name);
        command
            ->add_option_function<double>(
                limitOption(metric),
                [options, &metric](double limit) {
                    options->limits[metric.key] = limit;
                    options->metrics.hdrFlip = options->metrics.hdrFlip || &metric == findMetric("hdr_flip");
                },
                text)
            ->type_name("X")
            ->check(metric.largerIsBetter ? between(-1.0, 1.0) : between(0.0, 1e300))
            ->group("Limits");
    }
}

}  // namespace

void addDiffCommand(CLI::App& app, int* exitCode) {
    CLI::App* command = app.add_subcommand("diff", "How far a picture is from a reference");
    const auto options = std::make_shared<DiffOptions>();
    command->add_option("picture", options->test, "The picture in question")->required()->type_name("A");
    command->add_option("reference", options->reference, "What it should be")->required()->type_name("B");
    command->add_option("--maps", options->maps, "Write error maps in false colours into the folder DIR")
        ->type_name("DIR")
        ->check(CLI::Validator(
            [](std::string& folder) {
                return folder.empty() ? std::string("expected a folder's name") : std::string();
            },
            ""));
    addJsonOption(*command, &options->json);
    MetricOptions& metrics = options->metrics;
    command->add_option("--epsilon", metrics.relativeEpsilon, "Added to the denominators of relative errors")
        ->type_name("X")
        ->check(aboveZero())
        ->capture_default_str();
    command
        ->add_option("--trim", metrics.trimmedShare,
                     "Share of the worst pixels that relMSE trimmed leaves out")
        ->type_name("SHARE")
        ->check(between(0.0, 0.999))
        ->capture_default_str();
    command->add_option("--exposure", metrics.exposureStops, "Stops, for SSIM and FLIP only")
        ->type_name("STOPS")
        ->check(between(-60.0, 60.0))
        ->capture_default_str();
    command
        ->add_option("--pixels-per-degree", metrics.pixelsPerDegree, "Of the viewer's visual angle, for FLIP")
        ->type_name("N")
        ->check(between(1.0, 1000.0))
        ->capture_default_str();
    command->add_flag("--hdr-flip", metrics.hdrFlip,
                      "Also HDR-FLIP, over a range of exposures; takes several times as long");
    command->add_option("--threads", metrics.threads, "Default: all")
        ->type_name("N")
        ->check(CLI::Range(1, 1024));
    addLimitOptions(command, options.get());
    command->footer(kFooter);
    command->callback([options, exitCode] { *exitCode = runDiff(*options); });
}

}  // namespace glint
