// Photon mapping's passes on a back end without a session, and what they leave. Header only, as host_cuda.h.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstring>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "engine/render/backend.h"
#include "engine/render/sppm_integrator.h"
#include "engine/render/sppm_state.h"

namespace glint::test {

/// The statistics after some passes, and the direct light of the last one.
struct Photons {
    SppmState state;
    std::vector<PixelSample> direct{};
};

inline void renderPasses(Backend& backend, SppmParams params, uint32_t passes, Photons* photons) {
    const std::atomic<bool> stop{false};
    for (uint32_t i = 0; i < passes; ++i) {
        params.pass.pass = photons->state.passes;
        const auto done = renderSppmPass(backend, params, stop, &photons->state, &photons->direct);
        ASSERT_TRUE(done) << done.error().message;
        ASSERT_TRUE(*done);
    }
}

inline Photons render(Backend& backend, const SppmParams& params, uint32_t passes) {
    Photons photons{SppmState(params.pass.width, params.pass.height)};
    renderPasses(backend, params, passes, &photons);
    return photons;
}

inline Photons renderOnCpu(const std::shared_ptr<const BuiltScene>& scene, const SppmParams& params,
                           uint32_t passes) {
    const auto cpu = makeCpuBackend(2);
    EXPECT_TRUE(cpu->setScene(scene));
    return render(*cpu, params, passes);
}

/// SppmPixel has no padding, so its bytes are its value.
static_assert(sizeof(SppmPixel) == 5 * sizeof(double) + 4 * sizeof(float));
inline size_t differingPixels(const SppmState& a, const SppmState& b) {
    EXPECT_EQ(a.pixels.size(), b.pixels.size());
    size_t differing = 0;
    for (size_t i = 0; i < std::min(a.pixels.size(), b.pixels.size()); ++i) {
        differing += std::memcmp(&a.pixels[i], &b.pixels[i], sizeof(SppmPixel)) != 0;
    }
    return differing;
}

inline void expectSame(const Photons& a, const Photons& b) {
    EXPECT_EQ(a.state.passes, b.state.passes);
    EXPECT_EQ(a.state.emittedPhotons, b.state.emittedPhotons);
    EXPECT_EQ(differingPixels(a.state, b.state), 0u);
    ASSERT_EQ(a.direct.size(), b.direct.size());
    size_t differing = 0;
    for (size_t i = 0; i < a.direct.size(); ++i) {
        differing += std::memcmp(&a.direct[i].radiance, &b.direct[i].radiance, sizeof(Vec3)) != 0 ||
                     a.direct[i].fault != b.direct[i].fault || a.direct[i].rays != b.direct[i].rays;
    }
    EXPECT_EQ(differing, 0u);
}

}  // namespace glint::test
