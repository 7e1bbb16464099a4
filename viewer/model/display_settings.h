// How the image is shown. Nothing here restarts a render.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "engine/render/tonemap.h"
#include "engine/scene/integrator_kind.h"
#include "viewer/model/image_framing.h"
#include "viewer/model/shown_image.h"

namespace glint {

/// The two integrators of a comparison, in the order of the table of integrators.
struct ComparedPair {
    IntegratorKind left = IntegratorKind::PathTracing;
    IntegratorKind right = IntegratorKind::Sppm;
};

/// How two pictures are seen together.
enum class CompareView : uint8_t {
    Wipe,              ///< left and right of a divider
    Flip,              ///< one after the other
    SideBySide,        ///< zoomed and moved together
    SignedDifference,  ///< left less right, in luminance
    FlipMap,           ///< what the eye sees of the difference (engine/report/flip.h)
};
inline constexpr int kCompareViews = 5;
inline bool isDifference(CompareView view) {
    return view == CompareView::SignedDifference || view == CompareView::FlipMap;
}

/// What undo brings back.
struct DisplayChoices {
    float exposureStops = 0.0f;
    float chosenExposureStops = 0.0f;  ///< for the scene that is open
    ToneMap toneMap = ToneMap::Srgb;
    WhiteBalance white{};
    bool dithers = false;
    std::shared_ptr<const OcioView> view{};  ///< in place of the tone map; null: none
    bool denoises = false;                   ///< the radiance is shown and saved without its noise
    ShownImage shown = ShownImage::Radiance;

    bool operator==(const DisplayChoices&) const = default;
};

/// What a change of them is called in the list of edits: "Display: exposure".
std::string editName(const DisplayChoices& before, const DisplayChoices& after);

struct DisplaySettings : DisplayChoices {
    bool autoExposure = true;  ///< a scene that is opened gets the exposure that its first picture needs
    /// No exposure was chosen since the scene was opened, neither by the user nor for its first picture.
    bool awaitsExposure() const {
        return autoExposure && exposureStops == 0.0f && chosenExposureStops == 0.0f;
    }
    ImageFraming framing;
    bool split = false;    ///< two integrators beside each other, at equal render time
    float splitAt = 0.5f;  ///< the divider, as a share of the width of what is seen of the image
    CompareView compareView = CompareView::Wipe;
    bool flipsToRight = false;  ///< which of both CompareView::Flip shows
    /// What the scene's own integrator is compared with. Nothing, or that integrator itself: the first other
    /// one of the table.
    std::optional<IntegratorKind> comparedWith{};

    DisplayLook look() const { return {exposureStops, toneMap, white, dithers, view}; }
    void take(const DisplayLook& look);
    const DisplayChoices& choices() const { return *this; }
    void choose(const DisplayChoices& choices) { static_cast<DisplayChoices&>(*this) = choices; }
    IntegratorKind otherOf(IntegratorKind own) const;
    ComparedPair pairOf(IntegratorKind own) const;
    /// Whether a picture by `kind` is on screen where the scene's integrator is `own`.
    bool shows(IntegratorKind kind, IntegratorKind own) const;
};

}  // namespace glint
