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

void SppmState::clear() {
    passes = 0;
    emittedPhotons = 0;
    std::ranges::fill(pixels, SppmPixel{});
}

Vec3 SppmState::photonRadiance(size_t index) const {
    return glint::photonRadiance(pixels[index], static_cast<double>(emittedPhotons));
}

double SppmState::photonStandardError(size_t index) const {
    if (passes < 2) { return std::numeric_limits<double>::infinity(); }
    const double n = passes;
    return std::sqrt(static_cast<double>(pixels[index].passM2) / (n - 1.0) / n);
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
