// Which pass is next: a function of the pictures as they are and of what is asked for. Changes nothing.
#pragma once

#include "engine/kernels/pass.h"
#include "engine/render/session_images.h"

namespace glint {

struct NextPass {
    enum class Kind { None, Preview, PreviewAov, Film, FilmAov };
    Kind kind = Kind::None;
    IntegratorKind integrator = IntegratorKind::PathTracing;  ///< whose picture it is for

    bool isAov() const { return kind == Kind::PreviewAov || kind == Kind::FilmAov; }
    bool isPreview() const { return kind == Kind::Preview || kind == Kind::PreviewAov; }
    explicit operator bool() const { return kind != Kind::None; }
};

/// `captureWaits`: someone wants the film, so that no motion keeps to previews.
NextPass nextPass(const SessionImages& images, const RenderRequest& request, bool captureWaits);

/// A limit holds for the film that is shown; those compared with it must have had as much time too.
bool isLimitReached(const SessionImages& images, const RenderRequest& request);

/// The settings, size and number of a pass.
PassParams passParams(const SessionImages& images, const NextPass& pass);

}  // namespace glint
