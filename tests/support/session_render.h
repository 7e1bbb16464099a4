// A session from its start, or from a checkpoint, to a number of passes: for tests that compare what
// it leaves.
#pragma once

#include <memory>
#include <optional>

#include "engine/render/render_session.h"
#include "engine/render/sppm_state.h"

namespace glint::test {

/// Fails the test when the session does not finish or has nothing to capture.
SessionCapture renderSession(std::unique_ptr<Backend> backend, const SceneDescription& scene, uint32_t passes,
                             int threads, std::optional<ResumePoint> from = {});

/// The photons of a capture by SPPM; empty, and a failure of the test, for any other.
const SppmState& photonsOf(const SessionCapture& capture);

}  // namespace glint::test
