// A backend without a renderer, so that sessions can be tested for what they do: its pictures are a formula,
// its passes take as long as a test says, and it fails or throws when told.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "engine/render/backend.h"
#include "engine/render/render_session.h"

namespace glint::test {

/// Shared between a test and the backend that the session owns.
struct FakeControl {
    std::atomic<double> secondsPerPass{0.0};  ///< of a pass of any size
    std::atomic<double> secondsPerPath{0.0};  ///< added for each pixel
    std::atomic<bool> failPasses{false};
    std::atomic<bool> throwInPass{false};
    std::atomic<bool> failScenes{false};
    std::atomic<int> passes{0};
    std::atomic<int> stopped{0};
    std::atomic<int> aovPasses{0};
    std::atomic<int> scenes{0};
    std::atomic<int> buildsFailing{0};  ///< so many builds fail from now on
    std::atomic<double> buildSeconds{0.0};

    std::mutex mutex;
    std::vector<PassParams> begun;  ///< in order

    std::vector<PassParams> begunPasses() {
        const std::lock_guard lock(mutex);
        return begun;
    }
};

/// What the fake renders.
Vec3 fakeRadiance(int x, int y, uint32_t pass, uint32_t seed);

std::unique_ptr<Backend> makeFakeBackend(std::shared_ptr<FakeControl> control);

/// Options whose build function makes empty scenes and reports what the edit table says for each kind.
SessionOptions fakeOptions(std::shared_ptr<FakeControl> control);

/// A description of the given size that the fake build accepts.
std::shared_ptr<SceneDescription> fakeScene(int width, int height);

}  // namespace glint::test
