// SPPM's statistics as radiance and error, and the memory they need.
#include "engine/render/sppm_state.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/kernels/sppm_gather_kernel.h"
#include "engine/math/color.h"
#include "engine/render/photon_store.h"

namespace glint {

SppmState::SppmState(int columns, int rows)
    : width(columns), height(rows), pixels(static_cast<size_t>(columns) * static_cast<size_t>(rows)) {}

void SppmState::reset(int columns, int rows) {
    if (columns != width || rows != height) {
        *this = SppmState(columns, rows);
        return;
    }
    passes = 0;
    emittedPhotons = 0;
    std::ranges::fill(pixels, SppmPixel{});
}

Vec3 SppmState::radianceOf(size_t pixel) const {
    return photonRadiance(pixels[pixel], static_cast<double>(emittedPhotons));
}

double SppmState::standardErrorOf(size_t pixel) const {
    if (passes < 2) { return std::numeric_limits<double>::infinity(); }
    const double n = passes;
    return coverageFactor(pixels[pixel]) *
           std::sqrt(static_cast<double>(pixels[pixel].passM2) / (n - 1.0) / n);
}

double SppmState::biasOf(size_t pixel) const {
    return coverageFactor(pixels[pixel]) * static_cast<double>(pixels[pixel].bias);
}

std::vector<IntegratorMap> SppmState::maps() const {
    IntegratorMap radii{kRadiusMap, std::vector<float>(pixels.size())};
    IntegratorMap counts{kPhotonCountMap, std::vector<float>(pixels.size())};
    for (size_t i = 0; i < pixels.size(); ++i) {
        radii.values[i] = static_cast<float>(std::sqrt(pixels[i].radiusSquared));
        counts.values[i] = static_cast<float>(pixels[i].photonCount);
    }
    return {std::move(radii), std::move(counts)};
}

SppmMemory planSppmMemory(const SceneDescription& scene) {
    return planSppmMemory(scene.resolution.width, scene.resolution.height, scene.sppm.photonsPerPass,
                          kExpectedStores, size_t{scene.sppm.memoryBudgetMiB} << 20);
}

SppmMemory planSppmMemory(int width, int height, uint32_t photonsPerPass, double storedPerPhoton,
                          size_t budgetBytes) {
    SppmMemory plan;
    plan.pixelBytes = static_cast<size_t>(width) * static_cast<size_t>(height) * kSppmBytesPerPixel;
    plan.photonsPerPass = photonsPerPass;
    const double bytesPerPhoton = storedPerPhoton * static_cast<double>(PhotonStore::kBytesPerPhoton);
    double room = 0.5 * static_cast<double>(PhotonStore::kMaxPhotons) *
                  static_cast<double>(PhotonStore::kBytesPerPhoton);
    if (budgetBytes > 0) {
        const double left =
            budgetBytes > plan.pixelBytes ? static_cast<double>(budgetBytes - plan.pixelBytes) : 0.0;
        room = std::min(room, left);
    }
    const double most = std::floor(room / bytesPerPhoton);
    if (static_cast<double>(photonsPerPass) > most) {
        plan.photonsPerPass = static_cast<uint32_t>(std::max(1.0, most));
    }
    plan.photonBytes = static_cast<size_t>(static_cast<double>(plan.photonsPerPass) * bytesPerPhoton);
    return plan;
}

}  // namespace glint
