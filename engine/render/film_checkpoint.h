// A film as a section of a checkpoint, exactly. Payload: u32 width, u32 height, u32 passes, u64 rays, u64
// fault counts, u32 number of fault records, records (u8 kind, u32 x, u32 y, u32 pass), the calibration (u32
// passes, f64 mean luminance, f64 correlated pixels, f64 factors), then per pixel 3 f64 mean, f64 M2, u32
// count, f32 mean of half the passes.
#pragma once

#include "engine/io/byte_stream.h"
#include "engine/render/film.h"

namespace glint {

struct FilmCheckpoint {
    static constexpr uint64_t kBytesPerPixel = 4 * sizeof(double) + sizeof(uint32_t) + sizeof(float);

    static void write(const Film& film, ByteWriter* out);
    /// False when the payload is not a film.
    static bool read(ByteReader in, Film* film);

  private:
    static bool readFaults(ByteReader* in, Film* film);
    static bool readCalibration(ByteReader* in, Film* film);
};

}  // namespace glint
