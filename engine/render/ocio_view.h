// Displays and views of OpenColorIO configurations (the config.ocio of ACES, Blender and others), in place of
// the tone maps.
//
// Optional: without OpenColorIO in the build everything here is an error that says so.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/result.h"
#include "engine/math/vec.h"

namespace glint {

struct OcioChoice {
    std::string config;   ///< a file
    std::string display;  ///< "": the configuration's first
    std::string view;     ///< "": the display's first
};

/// "CONFIG", "CONFIG:display", "CONFIG:display/view" or "CONFIG:display:view"; an empty display is the first.
/// CONFIG ends at the last colon before which the text names a file, at the first colon where none does.
OcioChoice parseOcioChoice(const std::string& text);

struct OcioDisplay {
    std::string name;
    std::vector<std::string> views;
};

/// One view of a configuration.
class OcioView {
  public:
    OcioView(OcioChoice chosen, std::vector<OcioDisplay> offered)
        : choice(std::move(chosen)), displays(std::move(offered)) {}
    virtual ~OcioView() = default;
    OcioView(const OcioView&) = delete;
    OcioView& operator=(const OcioView&) = delete;

    /// Of radiance in linear Rec.709 that is exposed already, finite and not negative; what leaves [0, 1] is
    /// cut by who asks. On any thread.
    virtual Vec3 operator()(const Vec3& linear) const = 0;

    const OcioChoice choice;                  ///< with the names that were used
    const std::vector<OcioDisplay> displays;  ///< that there are to choose from
};

/// Applied by the library on the processor, for exactly what other programs show: Glint's linear Rec.709 is
/// found in the configuration by its usual names, or reached from the role aces_interchange; else
/// scene_linear is taken for it, with a warning. Error: the file cannot be read or is none, or there is no
/// such display or view, naming the nearest.
Result<std::shared_ptr<const OcioView>> loadOcioView(const OcioChoice& choice);

bool hasOcio();

}  // namespace glint
