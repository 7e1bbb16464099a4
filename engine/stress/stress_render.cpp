// Welford's update of each pixel's difference to its truth, joined over blocks.
#include "engine/stress/stress_render.h"

#include <cmath>
#include <limits>
#include <memory>

#include "engine/builders/scene_builder.h"
#include "engine/math/color.h"
#include "engine/render/backend.h"
#include "engine/render/pass_params.h"
#include "engine/render/path_pass.h"
#include "engine/render/sppm_integrator.h"
#include "engine/render/sppm_state.h"

namespace glint {
namespace {

Error stoppedError() { return {"the stability suite was stopped", {}}; }

/// Running mean and squared deviations (Welford 1962).
struct Tally {
    double mean = 0.0;
    double m2 = 0.0;
    uint64_t count = 0;

    void add(double x) {
        ++count;
        const double before = x - mean;
        mean += before / static_cast<double>(count);
        m2 += before * (x - mean);
    }
    /// Squared standard error of the mean; infinite with fewer than two samples.
    double squaredError() const {
        const double n = static_cast<double>(count);
        return count < 2 ? std::numeric_limits<double>::infinity() : m2 / (n * (n - 1.0));
    }
};

/// Of one pixel: the difference to its truth, and that truth.
struct PixelTally {
    Tally difference;
    Tally truth;
};

double luminanceOf(const PixelSample& sample) { return static_cast<double>(luminance(sample.radiance)); }

/// A scene and the back end that renders it.
class Renderer {
  public:
    explicit Renderer(int threads) : threads_(threads), backend_(makeCpuBackend(threads)) {}

    Status setScene(const SceneDescription& scene) {
        const SceneEdit edit{std::make_shared<const SceneDescription>(scene), EditKind::Everything};
        auto built = buildScene(edit, nullptr, threads_, nullptr, nullptr);
        if (!built) { return built.error(); }
        return backend_->setScene(*built);
    }

    Result<bool> pass(const PassParams& params, const StressEffort& effort) {
        return renderPathPass(*backend_, params, effort.stop != nullptr ? *effort.stop : never_, &samples);
    }

    Result<bool> photonPass(const SppmParams& params, const StressEffort& effort, SppmState* state) {
        return renderSppmPass(*backend_, params, effort.stop != nullptr ? *effort.stop : never_, state,
                              &samples);
    }

    std::vector<PixelSample> samples;

  private:
    int threads_;
    std::unique_ptr<Backend> backend_;
    std::atomic<bool> never_{false};
};

void countFaults(const std::vector<PixelSample>& samples, StressOutcome* outcome) {
    outcome->samples += samples.size();
    for (const PixelSample& sample : samples) {
        if (sample.fault != SampleFault::None) { ++outcome->faults[static_cast<size_t>(sample.fault)]; }
    }
}

/// The pixels of a blocks x blocks part of the picture; the last ones take what division leaves.
struct Block {
    int x0, y0, x1, y1;
};

std::vector<Block> blocksOf(int width, int height, int blocks) {
    std::vector<Block> result;
    for (int y = 0; y < blocks; ++y) {
        for (int x = 0; x < blocks; ++x) {
            result.push_back({x * width / blocks, y * height / blocks, (x + 1) * width / blocks,
                              (y + 1) * height / blocks});
        }
    }
    return result;
}

StressValue blockValue(const std::vector<PixelTally>& pixels, int width, const Block& block) {
    StressValue value;
    double difference = 0.0;
    double squaredError = 0.0;
    for (int y = block.y0; y < block.y1; ++y) {
        for (int x = block.x0; x < block.x1; ++x) {
            const PixelTally& pixel = pixels[static_cast<size_t>(y * width + x)];
            difference += pixel.difference.mean;
            value.truth += pixel.truth.mean;
            squaredError += pixel.difference.squaredError();
        }
    }
    const double count = static_cast<double>(block.x1 - block.x0) * (block.y1 - block.y0);
    value.truth /= count;
    value.measured = value.truth + difference / count;
    value.standardError = std::sqrt(squaredError) / count;
    return value;
}

void addBlockValues(const std::vector<PixelTally>& pixels, int width, int height, int blocks,
                    StressOutcome* outcome) {
    for (const Block& block : blocksOf(width, height, blocks)) {
        outcome->values.push_back(blockValue(pixels, width, block));
    }
}

Status passDone(const Result<bool>& done) {
    if (!done) { return done.error(); }
    return *done ? Status() : Status(stoppedError());
}

/// A picture of direct light and photons after `passes` passes.
Result<std::vector<double>> photonImage(Renderer* renderer, SppmParams params, uint32_t passes,
                                        const StressEffort& effort, StressOutcome* outcome) {
    const auto count = static_cast<size_t>(params.pass.width) * static_cast<size_t>(params.pass.height);
    SppmState state(params.pass.width, params.pass.height);
    std::vector<double> image(count, 0.0);
    for (uint32_t pass = 0; pass < passes; ++pass) {
        params.pass.pass = pass;
        if (Status done = passDone(renderer->photonPass(params, effort, &state)); !done) {
            return done.error();
        }
        countFaults(renderer->samples, outcome);
        for (size_t i = 0; i < count; ++i) {
            image[i] += luminanceOf(renderer->samples[i]) / passes;
        }
    }
    for (size_t i = 0; i < count; ++i) {
        image[i] += static_cast<double>(luminance(state.radianceOf(i)));
    }
    return image;
}

double blockMean(const std::vector<double>& image, int width, const Block& block) {
    double sum = 0.0;
    for (int y = block.y0; y < block.y1; ++y) {
        for (int x = block.x0; x < block.x1; ++x) {
            sum += image[static_cast<size_t>(y * width + x)];
        }
    }
    return sum / (static_cast<double>(block.x1 - block.x0) * (block.y1 - block.y0));
}

/// Photon runs of one or two scenes; truths by block from `truthOf`(the run's second picture).
struct PhotonRuns {
    uint32_t passes, runs;
    int blocks;
};

Result<StressOutcome> measurePhotonRuns(const SceneDescription& scene, const SceneDescription* benign,
                                        double truth, const PhotonRuns& plan, const StressEffort& effort) {
    Renderer first(effort.threads);
    Renderer second(effort.threads);
    if (Status ready = first.setScene(scene); !ready) { return ready.error(); }
    if (benign != nullptr) {
        if (Status ready = second.setScene(*benign); !ready) { return ready.error(); }
    }
    const Resolution size = scene.resolution;
    const std::vector<Block> blocks = blocksOf(size.width, size.height, plan.blocks);
    std::vector<PixelTally> tallies(blocks.size());
    StressOutcome outcome;
    for (uint32_t run = 0; run < plan.runs; ++run) {
        SppmParams params = sppmParamsOf(scene);
        params.pass.seed = run;
        const auto image = photonImage(&first, params, plan.passes, effort, &outcome);
        if (!image) { return image.error(); }
        std::vector<double> expected(image->size(), truth);
        if (benign != nullptr) {
            params = sppmParamsOf(*benign);
            params.pass.seed = run;
            auto rendered = photonImage(&second, params, plan.passes, effort, &outcome);
            if (!rendered) { return rendered.error(); }
            expected = std::move(*rendered);
        }
        for (size_t i = 0; i < blocks.size(); ++i) {
            const double is = blockMean(*image, size.width, blocks[i]);
            const double should = blockMean(expected, size.width, blocks[i]);
            tallies[i].difference.add(is - should);
            tallies[i].truth.add(should);
        }
    }
    for (const PixelTally& tally : tallies) {
        outcome.values.push_back({tally.truth.mean + tally.difference.mean, tally.truth.mean,
                                  std::sqrt(tally.difference.squaredError()),
                                  static_cast<int>(plan.runs) - 1});
    }
    return outcome;
}

}  // namespace

Result<StressOutcome> measurePaths(const SceneDescription& scene, uint32_t passes, const PixelTruth& truth,
                                   const StressEffort& effort, int blocks) {
    Renderer renderer(effort.threads);
    if (Status ready = renderer.setScene(scene); !ready) { return ready.error(); }
    PassParams params = passParamsOf(scene);
    std::vector<PixelTally> pixels(static_cast<size_t>(params.width) * static_cast<size_t>(params.height));
    for (size_t i = 0; i < pixels.size(); ++i) {
        const int index = static_cast<int>(i);
        pixels[i].truth.add(truth(index % params.width, index / params.width));
    }
    StressOutcome outcome;
    for (params.pass = 0; params.pass < passes; ++params.pass) {
        if (Status done = passDone(renderer.pass(params, effort)); !done) { return done.error(); }
        countFaults(renderer.samples, &outcome);
        for (size_t i = 0; i < pixels.size(); ++i) {
            if (renderer.samples[i].fault != SampleFault::None) { continue; }
            pixels[i].difference.add(luminanceOf(renderer.samples[i]) - pixels[i].truth.mean);
        }
    }
    addBlockValues(pixels, params.width, params.height, blocks, &outcome);
    return outcome;
}

Result<StressOutcome> measurePaths(const SceneDescription& scene, uint32_t passes, double truth,
                                   const StressEffort& effort, int blocks) {
    return measurePaths(
        scene, passes, [truth](int, int) { return truth; }, effort, blocks);
}

Result<StressOutcome> measurePathsAgainst(const SceneDescription& extreme, const SceneDescription& benign,
                                          uint32_t passes, const StressEffort& effort, int blocks) {
    Renderer first(effort.threads);
    Renderer second(effort.threads);
    if (Status ready = first.setScene(extreme); !ready) { return ready.error(); }
    if (Status ready = second.setScene(benign); !ready) { return ready.error(); }
    PassParams params = passParamsOf(extreme);
    std::vector<PixelTally> pixels(static_cast<size_t>(params.width) * static_cast<size_t>(params.height));
    StressOutcome outcome;
    for (params.pass = 0; params.pass < passes; ++params.pass) {
        if (Status done = passDone(first.pass(params, effort)); !done) { return done.error(); }
        if (Status done = passDone(second.pass(params, effort)); !done) { return done.error(); }
        countFaults(first.samples, &outcome);
        countFaults(second.samples, &outcome);
        for (size_t i = 0; i < pixels.size(); ++i) {
            const PixelSample& is = first.samples[i];
            const PixelSample& should = second.samples[i];
            if (is.fault != SampleFault::None || should.fault != SampleFault::None) { continue; }
            pixels[i].difference.add(luminanceOf(is) - luminanceOf(should));
            pixels[i].truth.add(luminanceOf(should));
        }
    }
    addBlockValues(pixels, params.width, params.height, blocks, &outcome);
    return outcome;
}

Result<StressOutcome> measurePhotons(const SceneDescription& scene, uint32_t passes, uint32_t runs,
                                     double truth, const StressEffort& effort) {
    return measurePhotonRuns(scene, nullptr, truth, {passes, runs, 1}, effort);
}

Result<StressOutcome> measurePhotonsAgainst(const SceneDescription& extreme, const SceneDescription& benign,
                                            uint32_t passes, uint32_t runs, const StressEffort& effort,
                                            int blocks) {
    return measurePhotonRuns(extreme, &benign, 0.0, {passes, runs, blocks}, effort);
}

}  // namespace glint
