// What `glint converge` compares, as text: an integrator and settings that differ from the scene's own, such
// as "sppm:radius=auto:2" or "path:sampler=independent:threads=1".
//
// It names nothing that Glint does not have: most keys are fields that name a variant.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/base/result.h"
#include "engine/scene/render_options.h"

namespace glint {

/// Everything that a variant can change. Starts as the scene's own settings and the command's defaults.
struct VariantSettings {
    RenderOptions options;
    SppmOptions sppm;
    int threads = 0;  ///< 0: all
    std::string backend = "cpu";
    bool denoise = false;     ///< measure the picture without its noise (denoised_snapshot.h)
    bool fullKernel = false;  ///< the kernel that does everything instead of the smallest that will do
};

struct ConvergenceVariant {
    std::string name;  ///< as in tables and plots: "sppm radius=auto:2"
    std::string text;  ///< as on the command line: "sppm:radius=auto:2"
    IntegratorKind integrator = IntegratorKind::PathTracing;
    std::vector<std::pair<std::string, std::string>> assignments;  ///< checked

    VariantSettings applyTo(VariantSettings settings) const;
};

/// An integrator's name (integrator_kind.h) such as "path" or its alias "pt", then any number of
/// ":key=value". A piece without
/// "=" goes on with the value before it, so that "radius=auto:2" needs no quotes. Error: an unknown name or
/// key, naming the nearest; a key that the integrator does not have or that stands twice; a value that is not
/// what the key expects.
Result<ConvergenceVariant> parseVariant(std::string_view text);

/// A comma-separated list. Error also: it is empty, or two of them are the same.
Result<std::vector<ConvergenceVariant>> parseVariants(std::string_view list);

/// All keys with what they expect, a line each: for the command's help.
std::string variantHelp();

}  // namespace glint
