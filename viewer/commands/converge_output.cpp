#include "viewer/commands/converge_output.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include <fmt/format.h>
#include <unistd.h>

#include "engine/io/atomic_file.h"
#include "engine/report/convergence_charts.h"
#include "engine/report/convergence_images.h"
#include "engine/report/convergence_page.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

constexpr const char* kImages = "pictures";

/// All that a run replaces, but not the reference, which is kept to be used again.
constexpr std::array<const char*, 7> kOwnNames{"index.html", "summary.json", "curve.csv", "summary.csv",
                                               "plot.svg",   "plot.png",     kImages};

Error cannotWrite(const std::string& path, const std::string& why) {
    return {fmt::format("--out {}: {}", path, why), {}};
}

/// The first existing folder on the way up from `path`.
fs::path existingParent(fs::path path) {
    std::error_code ignored;
    path = fs::absolute(path, ignored);
    while (!fs::exists(path, ignored) && path.has_parent_path() && path != path.parent_path()) {
        path = path.parent_path();
    }
    return path;
}

}  // namespace

Status ConvergeFolder::check(bool overwrite, const RunFiles& files) const {
    std::error_code ignored;
    if (path_.empty()) { return Error{"--out is empty; expected a folder", {}}; }
    const fs::path parent = existingParent(path_);
    if (!fs::is_directory(parent, ignored)) {
        return cannotWrite(path_, fmt::format("{} is a file; expected a folder", parent.string()));
    }
    if (access(parent.c_str(), W_OK) != 0) {
        return cannotWrite(path_, fmt::format("{}: {}", parent.string(), std::strerror(errno)));
    }
    for (const char* name : kOwnNames) {
        if (!overwrite && fs::exists(file(name), ignored)) {
            return cannotWrite(path_,
                               fmt::format("{} is there already; expected another folder, or --overwrite "
                                           "to replace an earlier run's results",
                                           name));
        }
        const bool isFile = std::string_view(name) != kImages && fs::exists(file(name), ignored);
        Status free = isFile ? files.checkCanWrite(file(name)) : files.checkIsFree(file(name));
        if (!free) { return free; }
    }
    if (Status free = files.checkHoldsNoInput(file(kImages)); !free) { return free; }
    return files.checkIsFree(reference());
}

Status ConvergeFolder::make() const {
    std::error_code problem;
    fs::create_directories(path_, problem);
    return problem ? Status(cannotWrite(path_, problem.message())) : Status();
}

void ConvergeFolder::removeIfEmpty() const {
    std::error_code ignored;
    fs::remove(path_, ignored);  // leaves a folder that holds something
}

std::string ConvergeFolder::file(const std::string& name) const { return (fs::path(path_) / name).string(); }

Status ConvergeFolder::write(const ConvergenceReport& report, ConvergenceResult* result) const {
    const std::array<std::pair<const char*, std::string (*)(const ConvergenceReport&)>, 3> texts{
        {{"curve.csv", curveCsv}, {"summary.csv", summaryCsv}, {"summary.json", summaryJson}}};
    const Result<ImageLegend> legend = saveImages(path_, report.plan, report.reference, result);
    // Numbers first: a picture that cannot be written must not cost them.
    for (const auto& [name, textOf] : texts) {
        if (Status written = writeFileAtomically(file(name), textOf(report)); !written) { return written; }
    }
    if (!legend) { return legend.error(); }
    const LogLogChart chart = errorChart(report, ErrorMeasure::RelativeError);
    for (const char* name : {"plot.svg", "plot.png"}) {
        if (Status saved = saveChart(file(name), chart); !saved) { return saved; }
    }
    return writeFileAtomically(file("index.html"), convergencePage(report, path_, *legend));
}

}  // namespace glint
