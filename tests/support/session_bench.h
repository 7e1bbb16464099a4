// A session with a fake backend for tests: no renderer, no OpenMP, so that the thread sanitizer sees
// every lock.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <thread>

#include "tests/support/fake_backend.h"

namespace glint::test {

inline constexpr double kPatience = 60.0;

struct SessionBench {
    std::shared_ptr<FakeControl> control = std::make_shared<FakeControl>();
    SessionOptions options = fakeOptions(control);
    std::unique_ptr<RenderSession> session;
    RenderRequest request;

    explicit SessionBench(bool previews = true) {
        options.previews = previews;
        session = std::make_unique<RenderSession>(makeFakeBackend(control), options);
    }
    /// Changes one thing of what is asked for.
    template <class Value>
    void ask(Value RenderRequest::*what, Value value) {
        request.*what = std::move(value);
        session->request(request);
    }
    void limit(const StopLimits& limits) { ask(&RenderRequest::limits, limits); }
    void open(int width, int height) { session->post({fakeScene(width, height), EditKind::Everything}); }
    static bool waitFor(const std::function<bool()>& condition) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(kPatience);
        while (!condition()) {
            if (std::chrono::steady_clock::now() > end) { return false; }
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return true;
    }
};

}  // namespace glint::test
