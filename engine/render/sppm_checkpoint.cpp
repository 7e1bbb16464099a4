// Field by field, since the padding and order of SppmPixel are the compiler's.
#include "engine/render/sppm_checkpoint.h"

#include <cmath>

namespace glint {
namespace {

bool plausible(const SppmPixel& pixel) {
    const auto fine = [](double x) { return std::isfinite(x) && x >= 0.0; };
    return fine(pixel.radiusSquared) && fine(pixel.photonCount);
}

}  // namespace

void writeSppmState(const SppmState& state, ByteWriter* out) {
    out->reserve(out->bytes().size() + state.pixels.size() * kSppmCheckpointBytesPerPixel + 64);
    out->write(static_cast<uint32_t>(state.width));
    out->write(static_cast<uint32_t>(state.height));
    out->write(state.passes);
    out->write(state.emittedPhotons);
    for (const SppmPixel& pixel : state.pixels) {
        out->write(pixel.radiusSquared);
        out->write(pixel.photonCount);
        for (const double flux : pixel.flux) {
            out->write(flux);
        }
        out->write(pixel.bias);
        out->write(pixel.passM2);
    }
}

bool readSppmState(ByteReader in, const Film& film, SppmState* state) {
    const auto width = in.read<uint32_t>();
    const auto height = in.read<uint32_t>();
    const auto passes = in.read<uint32_t>();
    const auto emitted = in.read<uint64_t>();
    if (in.failed() || width != static_cast<uint32_t>(film.width()) ||
        height != static_cast<uint32_t>(film.height()) || passes != film.passes() ||
        in.left() != uint64_t{width} * height * kSppmCheckpointBytesPerPixel) {
        return false;
    }
    SppmState out(film.width(), film.height());
    out.passes = passes;
    out.emittedPhotons = emitted;
    for (SppmPixel& pixel : out.pixels) {
        pixel.radiusSquared = in.read<double>();
        pixel.photonCount = in.read<double>();
        for (double& flux : pixel.flux) {
            flux = in.read<double>();
        }
        pixel.bias = in.read<float>();
        pixel.passM2 = in.read<float>();
        if (!plausible(pixel)) { return false; }
    }
    *state = std::move(out);
    return !in.failed();
}

}  // namespace glint
