// Renders each variant with each seed from cold and measures its error on the way.
//
// The first seed of a variant stops at the schedule's seconds (or passes); the others stop at the same pass
// counts, so that a point's spread over the seeds is that of the method, not of the machine. Seeds are the
// outer loop: a machine that slows down slows all variants, and an interrupted run has something of each.
// Evaluating, saving and building take no render seconds.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/report/convergence_measures.h"
#include "engine/report/convergence_reference.h"
#include "engine/report/convergence_session.h"
#include "engine/report/convergence_variant.h"

namespace glint {

struct ConvergencePlan {
    std::vector<ConvergenceVariant> variants;
    VariantSettings defaults;  ///< the scene's settings and the command's options
    std::vector<uint32_t> seeds;
    double seconds = 0.0;  ///< of rendering, for each variant and seed; 0: `passes` counts
    uint32_t passes = 0;
    int points = 16;
    int images = 3;  ///< kept of the first seed: the end's, and those of a tenth, a hundredth ... of the work
    /// instead of these: seconds (or passes), rising; the end's is kept too
    std::vector<double> imageMoments{};
    double exposureStops = 0.0;  ///< at which SSIM and FLIP look
};

struct MeasuredPoint {
    uint32_t passes = 0;
    double seconds = 0.0;
    ErrorValues errors{};
};

/// One seed of one variant. Points in order of passes; those of a variant's seeds with the same index have
/// the same passes, but a curve that was cut short has fewer.
struct MeasuredCurve {
    uint32_t seed = 0;
    std::vector<MeasuredPoint> points;
};

struct KeptImage {
    size_t point = 0;  ///< of the first seed's curve
    ImageF image;
    std::string file{};       ///< where it was saved, relative to the report; empty: not yet
    std::string errorFile{};  ///< the same of its error map
};

struct MeasuredVariant {
    ConvergenceVariant variant;
    VariantSettings settings;
    std::string backend;  ///< as it calls itself
    std::string kernel;
    std::string problem;  ///< why it could not be rendered (to the end); empty: nothing happened
    uint64_t droppedSamples = 0;
    std::vector<MeasuredCurve> curves;
    std::vector<KeptImage> images;
    /// Of the last point, over the seeds that reached it; both as mean over all pixels and channels.
    int finalSeeds = 0;
    double finalVariance = 0.0;      ///< unbiased, of one seed's picture; needs two seeds
    double finalMeanImageMse = 0.0;  ///< of the mean of the seeds' pictures against the reference
};

struct ConvergenceResult {
    std::vector<MeasuredVariant> variants;
    bool interrupted = false;
};

/// A variant that fails is recorded and the others go on.
ConvergenceResult runConvergence(const ConvergencePlan& plan, const SceneDescription& scene,
                                 const ReferenceImage& reference, const ConvergenceHost& host);

/// `count` seeds from `first` on, without those in `taken`: a picture of the reference's own seeds would
/// share its noise.
std::vector<uint32_t> seedsBeside(const std::vector<uint32_t>& taken, uint32_t first, int count);

}  // namespace glint
