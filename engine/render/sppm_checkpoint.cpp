// Field by field, since the padding and order of SppmPixel are the compiler's.
#include <cmath>

#include "engine/render/film.h"
#include "engine/render/sppm_state.h"

namespace glint {
namespace {

constexpr size_t kBytesPerPixel = 5 * sizeof(double) + 4 * sizeof(float);
constexpr size_t kOlderBytesPerPixel = kBytesPerPixel - 2 * sizeof(float);  // without coverage

bool plausible(const SppmPixel& pixel) {
    const auto fine = [](double x) { return std::isfinite(x) && x >= 0.0; };
    return fine(pixel.radiusSquared) && fine(pixel.photonCount) && pixel.covered >= 0.0f &&
           pixel.covered <= pixel.probes;
}

}  // namespace

size_t SppmState::sectionBytes(size_t pixelCount) const { return pixelCount * kBytesPerPixel; }

void SppmState::write(ByteWriter* out) const {
    out->write(static_cast<uint32_t>(width));
    out->write(static_cast<uint32_t>(height));
    out->write(passes);
    out->write(emittedPhotons);
    for (const SppmPixel& pixel : pixels) {
        out->write(pixel.radiusSquared);
        out->write(pixel.photonCount);
        for (const double flux : pixel.flux) {
            out->write(flux);
        }
        out->write(pixel.bias);
        out->write(pixel.passM2);
        out->write(pixel.probes);
        out->write(pixel.covered);
    }
}

bool SppmState::read(ByteReader in, const Film& film) {
    const auto columns = in.read<uint32_t>();
    const auto rows = in.read<uint32_t>();
    SppmState out(film.width(), film.height());
    out.passes = in.read<uint32_t>();
    out.emittedPhotons = in.read<uint64_t>();
    const bool hasCoverage = in.left() != out.pixels.size() * kOlderBytesPerPixel;
    if (in.failed() || columns != static_cast<uint32_t>(film.width()) ||
        rows != static_cast<uint32_t>(film.height()) || out.passes != film.passes() ||
        (hasCoverage && in.left() != out.pixels.size() * kBytesPerPixel)) {
        return false;
    }
    for (SppmPixel& pixel : out.pixels) {
        pixel.radiusSquared = in.read<double>();
        pixel.photonCount = in.read<double>();
        for (double& flux : pixel.flux) {
            flux = in.read<double>();
        }
        pixel.bias = in.read<float>();
        pixel.passM2 = in.read<float>();
        if (hasCoverage) {
            pixel.probes = in.read<float>();
            pixel.covered = in.read<float>();
        }
        if (!plausible(pixel)) { return false; }
    }
    *this = std::move(out);
    return !in.failed();
}

}  // namespace glint
