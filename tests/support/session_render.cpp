#include "tests/support/session_render.h"

#include <gtest/gtest.h>

namespace glint::test {

SessionCapture renderSession(std::unique_ptr<Backend> backend, const SceneDescription& scene, uint32_t passes,
                             int threads, std::optional<ResumePoint> from) {
    RenderSession session(std::move(backend), {.previews = false, .snapshots = false, .threads = threads});
    session.request({.limits = {.passes = passes}});
    const auto shared = std::make_shared<SceneDescription>(scene);
    if (from) {
        session.resume(shared, std::move(*from));
    } else {
        session.post({shared, EditKind::Everything});
    }
    EXPECT_EQ(session.wait(300.0), SessionState::Finished) << session.status().error;
    auto capture = session.capture();
    EXPECT_TRUE(capture.has_value());
    return capture ? std::move(*capture) : SessionCapture{.scene = shared};
}

const SppmState& photonsOf(const SessionCapture& capture) {
    static const SppmState kNone;
    const SppmState* photons = asSppm(capture.statistics.get());
    EXPECT_NE(photons, nullptr);
    return photons != nullptr ? *photons : kNone;
}

}  // namespace glint::test
