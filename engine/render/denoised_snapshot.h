// Pictures without their noise (engine/denoise), made of snapshots. Films never change.
#pragma once

#include <atomic>
#include <memory>

#include "engine/kernels/pass.h"
#include "engine/render/film_snapshot.h"

namespace glint {

/// The layers that a snapshot has to carry for it, beside its standard error.
constexpr uint32_t kDenoisingAovs = kAovAlbedo | kAovShadingNormal | kAovDepth;

enum class DenoiseQuality : uint8_t { Quick, Careful };

/// The picture without its noise, with isDenoised set; where it has standard errors, these are its estimated
/// errors from then on. All else is as it was. Photons' noise is alike in neighbouring pixels, which is taken
/// for light: of that of SPPM less goes away, and nothing of its bias. Null where the snapshot lacks the
/// layers or the standard error, or where `stop` (may be null) was raised meanwhile.
std::shared_ptr<FilmSnapshot> denoisedSnapshot(const FilmSnapshot& snapshot, DenoiseQuality quality,
                                               int threads, const std::atomic<bool>* stop = nullptr);

}  // namespace glint
