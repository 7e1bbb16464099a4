// Sections: INFO (text Glint version, f64 render seconds), SETT (u32 count, then name and value texts), HASH
// (u32 count, then u64 low and high per scene part), FILM (film_checkpoint.h), PERR (u32 count, then u32
// passes and 5 f64 per point of the convergence curve), and that of the integrator's statistics where it has
// some, READ and SCNE (checkpoint_scene.h). A section with other letters is skipped. Texts are u64 length
// and characters.
#include "engine/render/checkpoint.h"

#include <filesystem>
#include <map>

#include <fmt/format.h>

#include "engine/base/log.h"
#include "engine/io/atomic_file.h"
#include "engine/io/file_kind.h"
#include "engine/render/checkpoint_scene.h"
#include "engine/render/checkpoint_sections.h"
#include "engine/render/film_checkpoint.h"

namespace glint {
namespace {

constexpr uint32_t kMaxSettings = 1000;

void writeInfo(const SessionCapture& capture, CheckpointWriter* file) {
    file->section("INFO", [&](ByteWriter* out) {
        out->writeText(GLINT_VERSION);
        out->write(capture.renderSeconds);
    });
    file->section("SETT", [&](ByteWriter* out) {
        const std::vector<Setting> settings = renderSettings(*capture.scene);
        out->write(static_cast<uint32_t>(settings.size()));
        for (const Setting& setting : settings) {
            out->writeText(setting.name);
            out->writeText(setting.value);
        }
    });
    file->section("HASH", [&](ByteWriter* out) {
        out->write(static_cast<uint32_t>(kScenePartCount));
        for (const Hash128& part : hashSceneParts(*capture.scene).parts) {
            out->write(part.low);
            out->write(part.high);
        }
    });
}

Result<CheckpointInfo> readInfo(const CheckpointSections& sections, const std::string& path) {
    for (const char* tag : {"INFO", "SETT", "HASH", "FILM"}) {
        if (!sections.contains(tag)) {
            return checkpointError(path, fmt::format("is damaged: the section {} is missing", tag));
        }
    }
    CheckpointInfo info;
    ByteReader about(sections.at("INFO"));
    info.glintVersion = about.readText();
    info.renderSeconds = about.read<double>();
    ByteReader settings(sections.at("SETT"));
    const uint32_t count = settings.read<uint32_t>();
    for (uint32_t i = 0; i < count && i < kMaxSettings && !settings.failed(); ++i) {
        std::string name = settings.readText();
        info.settings.push_back({std::move(name), settings.readText()});
    }
    ByteReader hashes(sections.at("HASH"));
    const bool rightParts = hashes.read<uint32_t>() == kScenePartCount;
    for (Hash128& part : info.hashes.parts) {
        part.low = hashes.read<uint64_t>();
        part.high = hashes.read<uint64_t>();
    }
    ByteReader film(sections.at("FILM"));
    film.readRaw(2 * sizeof(uint32_t));
    info.passes = film.read<uint32_t>();
    info.scenePath = checkpointScenePath(sections);
    info.readWith = checkpointReadingOptions(sections);
    if (about.failed() || settings.failed() || count > kMaxSettings || hashes.failed() || !rightParts ||
        film.failed()) {
        return checkpointError(path, "is damaged: a section is too short");
    }
    return info;
}

void writeCurve(const ConvergenceCurve& curve, ByteWriter* out) {
    out->write(static_cast<uint32_t>(curve.points().size()));
    for (const ConvergencePoint& point : curve.points()) {
        out->write(point.passes);
        for (const double value : {point.renderSeconds, point.relativeError, point.relativeErrorLow,
                                   point.relativeErrorHigh, point.relativeBias}) {
            out->write(value);
        }
    }
}

/// False when the payload is not a curve. Of a checkpoint without one, or whose errors were relative to the
/// mean luminance (CURV): empty.
bool readCurve(const CheckpointSections& sections, ConvergenceCurve* curve) {
    const auto section = sections.find("PERR");
    if (section == sections.end()) { return true; }
    ByteReader in(section->second);
    const auto count = in.read<uint32_t>();
    uint32_t passes = 0;
    for (uint32_t i = 0; i < count && !in.failed(); ++i) {
        ConvergencePoint point;
        point.passes = in.read<uint32_t>();
        for (double* value : {&point.renderSeconds, &point.relativeError, &point.relativeErrorLow,
                              &point.relativeErrorHigh, &point.relativeBias}) {
            *value = in.read<double>();
        }
        if (i >= ConvergenceCurve::kMaxPoints || point.passes <= passes) { return false; }
        passes = point.passes;
        curve->add(point);
    }
    return !in.failed() && in.left() == 0;
}

/// False when the section is missing or not that of the film. True where the integrator keeps none.
bool readStatistics(const CheckpointSections& sections, const Film& film, ImageStatistics* statistics) {
    if (statistics == nullptr) { return true; }
    const auto section = sections.find(statistics->section().tag);
    return section != sections.end() && statistics->read(ByteReader(section->second), film);
}

/// Reads the file into `bytes`, which the sections point into.
Result<CheckpointInfo> openCheckpoint(const std::string& path, std::string* bytes,
                                      CheckpointSections* sections) {
    Result<std::string> read = readFileOfKind(path, looksLikeCheckpoint);
    if (!read) { return read.error(); }
    *bytes = std::move(*read);
    Result<CheckpointSections> found = findSections(*bytes, path);
    if (!found) { return found.error(); }
    *sections = std::move(*found);
    return readInfo(*sections, path);
}

/// Every difference between the checkpoint and the scene as it is now, separated by semicolons.
std::string differences(const CheckpointInfo& info, const SceneDescription& scene) {
    std::string out;
    const auto report = [&out](const std::string& text) { out += (out.empty() ? "" : "; ") + text; };
    const SceneHashes now = hashSceneParts(scene);
    for (size_t i = 0; i < now.parts.size(); ++i) {
        if (now.parts[i] != info.hashes.parts[i]) {
            const ScenePart part = static_cast<ScenePart>(i);
            report(
                fmt::format("{} {}", scenePartName(part),
                            part == ScenePart::Camera || part == ScenePart::Geometry ? "differs" : "differ"));
        }
    }
    std::map<std::string, std::string> stored;
    for (const Setting& setting : info.settings) {
        stored[setting.name] = setting.value;
    }
    for (const Setting& setting : renderSettings(scene)) {
        const auto found = stored.find(setting.name);
        if (found == stored.end()) {
            report(fmt::format("{} is not in the checkpoint and {} now", setting.name, setting.value));
        } else if (found->second != setting.value) {
            report(fmt::format("{} is {} in the checkpoint and {} now", setting.name, found->second,
                               setting.value));
        }
    }
    return out;
}

}  // namespace

size_t checkpointBytes(int width, int height, IntegratorKind integrator) {
    const size_t pixels = static_cast<size_t>(width) * static_cast<size_t>(height);
    const auto statistics = integratorType(integrator).makeStatistics();
    return pixels * FilmCheckpoint::kBytesPerPixel + (statistics ? statistics->sectionBytes(pixels) : 0);
}

Status saveCheckpoint(const std::string& path, const SessionCapture& capture) {
    const Film& film = capture.film;
    CheckpointWriter file(checkpointBytes(film.width(), film.height(), capture.scene->options.integrator) +
                          embeddedBytes(*capture.scene) + 65536);
    writeInfo(capture, &file);
    file.section("FILM", [&](ByteWriter* out) { FilmCheckpoint::write(film, out); });
    file.section("PERR", [&](ByteWriter* out) { writeCurve(capture.curve, out); });
    if (const ImageStatistics* statistics = capture.statistics.get()) {
        file.section(statistics->section().tag, [&](ByteWriter* out) { statistics->write(out); });
    }
    writeCheckpointScene(*capture.scene, &file);
    return writeFileAtomically(path, file.finish());
}

Result<ResumePoint> loadCheckpoint(const std::string& path, const SceneDescription& scene) {
    std::string bytes;
    CheckpointSections sections;
    const Result<CheckpointInfo> info = openCheckpoint(path, &bytes, &sections);
    if (!info) { return info.error(); }
    if (const std::string differing = differences(*info, scene); !differing.empty()) {
        return checkpointError(path, fmt::format("cannot go on from this checkpoint: {}", differing));
    }
    if (info->glintVersion != GLINT_VERSION) {
        logWarning("{}: was written by glint {}; what is added by {} may differ in its last bits", path,
                   info->glintVersion, GLINT_VERSION);
    }
    ResumePoint point;
    point.renderSeconds = info->renderSeconds;
    if (!FilmCheckpoint::read(ByteReader(sections.at("FILM")), &point.film)) {
        return checkpointError(path, "is damaged: its film cannot be read");
    }
    if (!readCurve(sections, &point.curve)) {
        return checkpointError(path, "is damaged: its convergence curve cannot be read");
    }
    point.statistics = integratorType(scene.options.integrator).makeStatistics();
    if (!readStatistics(sections, point.film, point.statistics.get())) {
        return checkpointError(
            path, fmt::format("is damaged: its {} cannot be read", point.statistics->section().name));
    }
    return point;
}

Result<SceneDescription> loadCheckpointScene(const std::string& path) {
    std::string bytes;
    CheckpointSections sections;
    const Result<CheckpointInfo> info = openCheckpoint(path, &bytes, &sections);
    return info ? readCheckpointScene(sections, path) : info.error();
}

bool isOfScene(const CheckpointInfo& info, const SceneDescription& scene) {
    std::error_code none;
    const std::string& file = info.scenePath;
    const std::string path = absolutePath(scene.path);
    if (file == path || (!file.empty() && std::filesystem::equivalent(file, path, none))) { return true; }
    const SceneHashes now = hashSceneParts(scene);
    constexpr auto kGeometry = static_cast<size_t>(ScenePart::Geometry);
    return now == info.hashes || (file.empty() && now.parts[kGeometry] == info.hashes.parts[kGeometry]);
}

Status checkReplacesCheckpoint(const std::string& path, uint32_t passes, const SceneDescription* scene) {
    std::error_code none;
    const bool isThere = std::filesystem::is_regular_file(path, none);
    if (!isThere || std::filesystem::file_size(path, none) == 0) { return {}; }
    const Result<CheckpointInfo> old = readCheckpointInfo(path);
    if (!old) {
        return Error{fmt::format("is there already and is not replaced, since it {}", old.error().message),
                     {.file = path}};
    }
    if (old->passes > passes) {
        return Error{
            fmt::format("holds a film of {} passes, which one of {} does not replace", old->passes, passes),
            {.file = path}};
    }
    if (scene == nullptr || isOfScene(*old, *scene)) { return {}; }
    const std::string name = std::filesystem::path(old->scenePath).filename().string();
    return Error{fmt::format("holds a film of another scene{}{}", name.empty() ? "" : ", ", name),
                 {.file = path}};
}

Result<CheckpointInfo> readCheckpointInfo(const std::string& path) {
    std::string bytes;
    CheckpointSections sections;
    return openCheckpoint(path, &bytes, &sections);
}

}  // namespace glint
