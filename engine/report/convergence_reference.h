// The picture that errors are measured against, with its own error bar: made here, or read from an EXR file
// together with what that file says about itself.
//
// A reference is the mean of renders with different seeds (replicates), because only their spread is an
// honest error bar for low-discrepancy points and for photons alike.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/report/convergence_session.h"
#include "engine/scene/image.h"

namespace glint {

struct ReferenceImage {
    ImageF image;
    std::vector<float> variance;  ///< squared standard error of each value, as picture.rgb; empty: not known
    std::string path;
    std::string method;  ///< a variant's text, such as "path"; empty: not known
    std::optional<IntegratorKind> integrator;
    std::vector<uint32_t> seeds;    ///< empty: not known
    double renderSeconds = 0.0;     ///< of all replicates; 0: not known
    double timeLimitSeconds = 0.0;  ///< what it was allowed to take; 0: not known
    uint64_t passes = 0;            ///< of all replicates; 0: not known
    std::string endedBy;  ///< "precision", "time" or "interrupt", of makeReference(); empty: not known
    bool cached = false;  ///< made by an earlier run
    std::vector<std::string> remarks;  ///< what everyone who reads the errors has to know

    double mean = 0.0;    ///< of all values
    double mse = 0.0;     ///< mean of `variance`: what it adds to a measured MSE
    double relMse = 0.0;  ///< the same of relMSE, with the default epsilon

    bool knowsItsError() const { return !variance.empty(); }
    double rmse() const;
    /// rmse over mean, as ErrorMeasure::RelativeError.
    double relativeError() const;
    /// Fills mean, mse and relMse.
    void summarize();
    /// What the integrator and a clamp of its samples (0: none) leave out of the error bar.
    void remarkBias(float fireflyClamp);
};

/// Reads R, G, B and standardError.R/G/B or .Y of an EXR picture and compares what it says about its
/// scene with `scene`; settings that change nothing but noise may differ. Error: not readable, another
/// size, or (unless `anyScene`, which makes it a remark) made of another scene or with settings that
/// change the expectation.
Result<ReferenceImage> loadReference(const std::string& path, const SceneDescription& scene, bool anyScene);

/// What keeps a picture that says so much about itself (the attributes of its EXR file) from being a
/// reference of `scene`: "" when nothing does. Without a "sceneHash" there is nothing to go by: ask for
/// that first.
std::string referenceDifference(const std::map<std::string, std::string>& attributes, SceneDescription scene);

struct ReferencePlan {
    ConvergenceVariant variant;
    VariantSettings settings;    ///< with the variant applied
    double renderSeconds = 0.0;  ///< the most it may take, but for the last passes of each replicate
    double relativeError = 0.0;  ///< it ends sooner when its own, as measured, is that small; 0: never
    uint32_t firstSeed = 0;
};

/// Replicates of a path-traced reference at least, and of one by photon mapping: fewer, since its bias
/// shrinks only within a replicate.
constexpr int kPathReplicates = 8;
constexpr int kPhotonReplicates = 2;

/// The first replicate decides by the limits, and by its own estimate of its error, how many passes each has;
/// then there are as many as above, and more of them while their spread says that the reference is not as
/// precise as wanted. Weighted by passes, the mean m of x_j has the variance estimate sum w_j (x_j - m)^2 /
/// (R - 1), sum w_j = 1. Nothing: interrupted before there were two. Error: nothing could be rendered.
Result<std::optional<ReferenceImage>> makeReference(const ReferencePlan& plan, const SceneDescription& scene,
                                                    const ConvergenceHost& host);

/// Float R, G, B, standardError.R/G/B, and .Y of the luminance with the channels' errors taken as one; and as
/// attributes what `glint render` writes and referenceMethod, referenceSeeds, referenceSeconds,
/// referenceTimeLimit, referencePasses, referenceEndedBy, referenceStandardError, referenceRelativeError and
/// referenceRemarks. `settings` made it.
Status saveReference(const std::string& path, const ReferenceImage& reference, SceneDescription scene,
                     const VariantSettings& settings);

}  // namespace glint
