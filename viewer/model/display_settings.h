// How the image is shown. Nothing here restarts a render.
#pragma once

#include <optional>

#include "engine/render/tonemap.h"
#include "engine/scene/integrator_kind.h"
#include "viewer/model/shown_image.h"

namespace glint {

/// The two integrators of a comparison, in the order of the table of integrators.
struct ComparedPair {
    IntegratorKind left = IntegratorKind::PathTracing;
    IntegratorKind right = IntegratorKind::Sppm;
};

struct DisplaySettings {
    float exposureStops = 0.0f;
    bool autoExposure = true;  ///< a scene that is opened gets the exposure that its first picture needs
    float chosenExposureStops = 0.0f;  ///< for the scene that is open
    ToneMap toneMap = ToneMap::Srgb;
    ShownImage shown = ShownImage::Radiance;
    bool pixelScale = false;  ///< one screen pixel an image pixel, instead of fitting the window
    bool split = false;       ///< two integrators beside each other, at equal render time
    float splitAt = 0.5f;     ///< the divider, as a share of the image's width
    /// What the scene's own integrator is compared with. Nothing, or that integrator itself: the first other
    /// one of the table.
    std::optional<IntegratorKind> comparedWith{};

    IntegratorKind otherOf(IntegratorKind own) const;
    ComparedPair pairOf(IntegratorKind own) const;
};

}  // namespace glint
