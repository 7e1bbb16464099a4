#include "engine/render/film_checkpoint.h"

#include <utility>

namespace glint {
namespace {

constexpr uint32_t kMaxSide = 1u << 20;

}  // namespace

void FilmCheckpoint::write(const Film& film, ByteWriter* out) {
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

bool FilmCheckpoint::read(ByteReader in, Film* film) {
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

bool FilmCheckpoint::readCalibration(ByteReader* in, Film* film) {
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

bool FilmCheckpoint::readFaults(ByteReader* in, Film* film) {
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

}  // namespace glint
