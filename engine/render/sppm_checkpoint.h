// SPPM's statistics as bytes, exactly: a checkpoint's section, which only checkpoint.cpp writes and reads.
//
// Payload: u32 width, u32 height, u32 passes, u64 emitted photons, then per pixel f64 squared radius, f64 N,
// 3 f64 tau, f32 mean and f32 M2 of the passes' own estimates.
#pragma once

#include "engine/io/byte_stream.h"
#include "engine/render/film.h"
#include "engine/render/sppm_state.h"

namespace glint {

constexpr size_t kSppmCheckpointBytesPerPixel = 5 * sizeof(double) + 2 * sizeof(float);

void writeSppmState(const SppmState& state, ByteWriter* out);

/// False when the payload is not the statistics of `film`: another size or number of passes, or a radius
/// or photon count that no render leaves behind (negative, infinite, not a number).
bool readSppmState(ByteReader in, const Film& film, SppmState* state);

}  // namespace glint
