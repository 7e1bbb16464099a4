// The file, all numbers little-endian:
//   8 bytes "GLINTCKP", u32 format version, u64 size of the whole file,
//   sections until the checksum: 4 letters, u64 payload size, payload,
//   16 bytes ContentHash of everything before.
// Sections: INFO (text Glint version, f64 render seconds), SETT (u32 count, then name and value texts), HASH
// (u32 count, then u64 low and high per scene part), FILM (see FilmCheckpoint), CURV (u32 count, then u32
// passes and 5 f64 per point of the convergence curve), and of SPPM alone SPPM (see sppm_checkpoint.h). A
// section with other letters is skipped. Texts are u64 length and characters.
#include "engine/render/checkpoint.h"

#include <map>

#include <fmt/format.h>

#include "engine/io/atomic_file.h"
#include "engine/io/byte_stream.h"
#include "engine/render/sppm_checkpoint.h"

namespace glint {

/// Reads and writes all of a film's members. Payload: u32 width, u32 height, u32 passes, u64 rays, u64 fault
/// counts, u32 number of fault records, records (u8 kind, u32 x, u32 y, u32 pass), the calibration (u32
/// passes, f64 mean luminance, f64 correlated pixels, f64 factors), then per pixel 3 f64 mean, f64 M2, u32
/// count, f32 waypoint.
struct FilmCheckpoint {
    static constexpr uint64_t kBytesPerPixel = 4 * sizeof(double) + sizeof(uint32_t) + sizeof(float);
    static constexpr uint32_t kMaxSide = 1u << 20;

    static void write(const Film& film, ByteWriter* out) {
        out->reserve(out->bytes().size() + film.pixels_.size() * kBytesPerPixel + 4096);
        out->write(static_cast<uint32_t>(film.width_));
        out->write(static_cast<uint32_t>(film.height_));
        out->write(film.passes_);
        out->write(film.rays_);
        for (const uint64_t count : film.faultCounts_) {
            out->write(count);
        }
        out->write(static_cast<uint32_t>(film.faults_.size()));
        for (const FaultRecord& fault : film.faults_) {
            out->write(static_cast<uint8_t>(fault.fault));
            out->write(static_cast<uint32_t>(fault.x));
            out->write(static_cast<uint32_t>(fault.y));
            out->write(fault.pass);
        }
        out->write(film.calibration_.passes);
        out->write(film.calibration_.meanLuminance);
        out->write(film.calibration_.correlatedPixels);
        for (const double factor : film.calibration_.factors) {
            out->write(factor);
        }
        for (const FilmPixel& pixel : film.pixels_) {
            for (const double mean : pixel.mean) {
                out->write(mean);
            }
            out->write(pixel.luminanceM2);
            out->write(pixel.count);
            out->write(pixel.halfSampleMean);
        }
    }

    /// False when the payload is not a film.
    static bool read(ByteReader in, Film* film) {
        const uint32_t width = in.read<uint32_t>();
        const uint32_t height = in.read<uint32_t>();
        const uint32_t passes = in.read<uint32_t>();
        const uint64_t rays = in.read<uint64_t>();
        const uint64_t pixels = uint64_t{width} * height;
        if (width == 0 || height == 0 || width > kMaxSide || height > kMaxSide ||
            pixels > in.left() / kBytesPerPixel) {
            return false;
        }
        Film out(static_cast<int>(width), static_cast<int>(height));
        out.passes_ = passes;
        out.rays_ = rays;
        if (!readFaults(&in, &out) || !readCalibration(&in, &out) || in.left() != pixels * kBytesPerPixel) {
            return false;
        }
        for (FilmPixel& pixel : out.pixels_) {
            for (double& mean : pixel.mean) {
                mean = in.read<double>();
            }
            pixel.luminanceM2 = in.read<double>();
            pixel.count = in.read<uint32_t>();
            pixel.halfSampleMean = in.read<float>();
        }
        *film = std::move(out);
        return !in.failed();
    }

  private:
    static bool readCalibration(ByteReader* in, Film* film) {
        NoiseCalibration& calibration = film->calibration_;
        calibration.passes = in->read<uint32_t>();
        calibration.meanLuminance = in->read<double>();
        calibration.correlatedPixels = in->read<double>();
        bool fine = calibration.correlatedPixels >= 1.0;
        for (double& factor : calibration.factors) {
            factor = in->read<double>();
            fine = fine && factor >= 0.0;
        }
        return fine && !in->failed();
    }

    static bool readFaults(ByteReader* in, Film* film) {
        for (uint64_t& count : film->faultCounts_) {
            count = in->read<uint64_t>();
        }
        const uint32_t records = in->read<uint32_t>();
        if (records > Film::kMaxFaultRecords) { return false; }
        for (uint32_t i = 0; i < records; ++i) {
            const uint8_t kind = in->read<uint8_t>();
            const uint32_t x = in->read<uint32_t>();
            const uint32_t y = in->read<uint32_t>();
            const uint32_t pass = in->read<uint32_t>();
            if (kind >= kSampleFaultCount || x >= static_cast<uint32_t>(film->width_) ||
                y >= static_cast<uint32_t>(film->height_)) {
                return false;
            }
            film->faults_.push_back(
                {static_cast<SampleFault>(kind), static_cast<int>(x), static_cast<int>(y), pass});
        }
        return !in->failed();
    }
};

namespace {

constexpr std::string_view kMagic = "GLINTCKP";
constexpr uint32_t kFormatVersion = 2;
constexpr uint64_t kChecksumBytes = 16;
constexpr uint32_t kMaxSettings = 1000;

Error checkpointError(const std::string& path, std::string message) {
    return {std::move(message), {.file = path}};
}

std::string checksumOf(std::string_view bytes) {
    ContentHash hash;
    hash.add(bytes);
    const Hash128 sum = hash.finish();
    ByteWriter out;
    out.write(sum.low);
    out.write(sum.high);
    return out.bytes();
}

/// Writes a section in place, since a film is too large to be copied about. `write` writes the payload.
template <class Write>
void writeSection(std::string_view tag, ByteWriter* out, Write write) {
    out->writeRaw(tag);
    const size_t sizeAt = out->bytes().size();
    out->write(uint64_t{0});
    write();
    out->overwrite(sizeAt, static_cast<uint64_t>(out->bytes().size() - sizeAt - sizeof(uint64_t)));
}

using Sections = std::map<std::string, std::string_view, std::less<>>;

/// Checks that the file is a whole one of this version, and finds its sections. The views point into `bytes`.
Result<Sections> findSections(std::string_view bytes, const std::string& path) {
    ByteReader in(bytes);
    if (in.readRaw(kMagic.size()) != kMagic) {
        return checkpointError(path, "is not a Glint checkpoint (its first bytes are not GLINTCKP)");
    }
    const uint32_t version = in.read<uint32_t>();
    const uint64_t size = in.read<uint64_t>();
    if (!in.failed() && version != kFormatVersion) {
        return checkpointError(path, fmt::format("has checkpoint format {}; this program reads format {}",
                                                 version, kFormatVersion));
    }
    if (in.failed() || size != bytes.size() || in.left() < kChecksumBytes) {
        return checkpointError(path, fmt::format("is cut off or damaged: it has {} bytes and should have {}",
                                                 bytes.size(), size));
    }
    const std::string_view summed = bytes.substr(0, bytes.size() - kChecksumBytes);
    if (bytes.substr(summed.size()) != checksumOf(summed)) {
        return checkpointError(path, "is damaged: its checksum is wrong");
    }
    Sections sections;
    while (!in.failed() && in.left() > kChecksumBytes) {
        const std::string tag(in.readRaw(4));
        sections[tag] = in.readRaw(in.read<uint64_t>());
    }
    if (in.failed() || in.left() != kChecksumBytes) {
        return checkpointError(path, "is damaged: a section is longer than the file");
    }
    return sections;
}

Result<CheckpointInfo> readInfo(const Sections& sections, const std::string& path) {
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

/// False when the payload is not a curve. Of a checkpoint without one: empty.
bool readCurve(const Sections& sections, ConvergenceCurve* curve) {
    const auto section = sections.find("CURV");
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

/// Reads the file into `bytes`, which the sections point into.
Result<CheckpointInfo> openCheckpoint(const std::string& path, std::string* bytes, Sections* sections) {
    Result<std::string> read = readFile(path);
    if (!read) { return read.error(); }
    *bytes = std::move(*read);
    Result<Sections> found = findSections(*bytes, path);
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

size_t checkpointBytes(int width, int height, bool sppm) {
    const size_t pixels = static_cast<size_t>(width) * static_cast<size_t>(height);
    return pixels * (FilmCheckpoint::kBytesPerPixel + (sppm ? kSppmCheckpointBytesPerPixel : 0));
}

Status saveCheckpoint(const std::string& path, const SessionCapture& capture) {
    const SceneDescription& scene = *capture.scene;
    ByteWriter file;
    // At once: growing would copy what is there already.
    file.reserve(checkpointBytes(capture.film.width(), capture.film.height(), capture.sppm.passes > 0) +
                 65536);
    file.writeRaw(kMagic);
    file.write(kFormatVersion);
    const size_t sizeAt = file.bytes().size();
    file.write(uint64_t{0});
    writeSection("INFO", &file, [&] {
        file.writeText(GLINT_VERSION);
        file.write(capture.renderSeconds);
    });
    writeSection("SETT", &file, [&] {
        const std::vector<Setting> settings = renderSettings(scene);
        file.write(static_cast<uint32_t>(settings.size()));
        for (const Setting& setting : settings) {
            file.writeText(setting.name);
            file.writeText(setting.value);
        }
    });
    writeSection("HASH", &file, [&] {
        file.write(static_cast<uint32_t>(kScenePartCount));
        for (const Hash128& part : hashSceneParts(scene).parts) {
            file.write(part.low);
            file.write(part.high);
        }
    });
    writeSection("FILM", &file, [&] { FilmCheckpoint::write(capture.film, &file); });
    writeSection("CURV", &file, [&] { writeCurve(capture.curve, &file); });
    if (scene.options.integrator == IntegratorKind::Sppm) {
        writeSection("SPPM", &file, [&] { writeSppmState(capture.sppm, &file); });
    }
    file.overwrite(sizeAt, static_cast<uint64_t>(file.bytes().size() + kChecksumBytes));
    file.writeRaw(checksumOf(file.bytes()));
    return writeFileAtomically(path, file.bytes());
}

Result<ResumePoint> loadCheckpoint(const std::string& path, const SceneDescription& scene) {
    std::string bytes;
    Sections sections;
    const Result<CheckpointInfo> info = openCheckpoint(path, &bytes, &sections);
    if (!info) { return info.error(); }
    if (const std::string differing = differences(*info, scene); !differing.empty()) {
        return checkpointError(path, fmt::format("cannot go on from this checkpoint: {}", differing));
    }
    ResumePoint point;
    point.renderSeconds = info->renderSeconds;
    if (!FilmCheckpoint::read(ByteReader(sections.at("FILM")), &point.film)) {
        return checkpointError(path, "is damaged: its film cannot be read");
    }
    if (!readCurve(sections, &point.curve)) {
        return checkpointError(path, "is damaged: its convergence curve cannot be read");
    }
    if (scene.options.integrator == IntegratorKind::Sppm) {
        const auto photons = sections.find("SPPM");
        if (photons == sections.end() ||
            !readSppmState(ByteReader(photons->second), point.film, &point.sppm)) {
            return checkpointError(path, "is damaged: its photon statistics cannot be read");
        }
    }
    return point;
}

Result<CheckpointInfo> readCheckpointInfo(const std::string& path) {
    std::string bytes;
    Sections sections;
    return openCheckpoint(path, &bytes, &sections);
}

}  // namespace glint
