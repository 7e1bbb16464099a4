// The stages of an SPPM pass as launches.

#include "cuda/cuda_sppm.h"

#include <algorithm>
#include <new>

#include <fmt/format.h>

#include "cuda/device_memory.h"
#include "cuda/paced_launches.h"
#include "cuda/sppm_variant.h"
#include "engine/base/check.h"
#include "engine/kernels/photon_surface.h"
#include "engine/kernels/sppm_pass_steps.h"
#include "engine/render/photon_store.h"
#include "engine/render/variant_choice.h"

namespace glint {
namespace {

/// Enough threads to fill a GPU, few enough results to be joined by the host.
constexpr uint32_t kSlices = 8192;
constexpr size_t kSliceBytes = std::max(sizeof(Bounds), sizeof(uint32_t));

size_t pixelCountOf(const SppmParams& params) {
    return static_cast<size_t>(params.pass.width) * static_cast<size_t>(params.pass.height);
}

/// The rest of the words that `what` begins: for messages about memory.
std::string needsOf(const SppmParams& params) {
    return fmt::format("Photon mapping with {}x{} pixels and {} photons a pass needs", params.pass.width,
                       params.pass.height, params.photonsPerPass);
}

}  // namespace

struct CudaSppm::Job {
    const SceneView& view;
    const PowerDistributionView& power;
    const SppmParams& params;
    const CudaSppmVariant& variant;
    const std::atomic<bool>& stop;
    PixelSample* image;

    uint32_t pixelThreads() const { return threadsOfPass(params.pass.width, params.pass.height); }
    size_t pixelCount() const { return pixelCountOf(params); }
};

Result<bool> CudaSppm::renderPass(const Scene& scene, const SppmParams& params, const std::atomic<bool>& stop,
                                  PixelSample* image, SppmState* state, std::vector<PixelSample>* direct) {
    GLINT_CHECK_OP(state->pixels.size(), ==, pixelCountOf(params));
    if (params.lookup != PhotonLookupKind::Grid) {
        return Error{
            "CUDA finds photons by the grid only: choose \"grid\" as the photon look-up, or render on "
            "the CPU.",
            {}};
    }
    if (Status s = PhotonStore::checkRoom(params.photonsPerPass); !s) { return s.error(); }
    const uint32_t room = std::max(photons_.room(), params.photonsPerPass);
    if (Status s = reserve(params, room); !s) { return s.error(); }
    if (Status s = uploadEmission(scene.host); !s) { return s.error(); }
    PowerDistributionView power = power_->view();
    power.cdf = powerCdf_.as<float>();
    const CudaSppmVariant& variant = chooseVariant(cudaSppmVariants(), scene.features, params.pass.sampler);
    const SppmParams settled = settledParams(scene.host, params);
    const Job job{scene.device, power, settled, variant, stop, image};
    if (Status s =
            device_.upload(statistics_.data(), state->pixels.data(), job.pixelCount() * sizeof(SppmPixel));
        !s) {
        return s.error();
    }
    if (const Result<bool> done = runStages(job); !done || !*done) { return done; }
    if (Status s = commit(job, state, direct); !s) { return s.error(); }
    return true;
}

Result<bool> CudaSppm::runStages(const Job& job) {
    if (const Result<bool> done = traceCamera(job); !done || !*done) { return done; }
    GridSpace space;
    uint32_t levelsInUse = 0;
    if (Status s = findSpace(job, &space, &levelsInUse); !s) { return s.error(); }
    uint32_t stored = 0;
    if (const Result<bool> done = tracePhotons(job, space, &stored); !done || !*done) { return done; }
    if (Status s = photons_.build(space, levelsInUse, job.params.photonsPerPass, stored); !s) {
        return s.error();
    }
    return gather(job);
}

/// All that the pass needs but for the tables of its grid, whose size the photons decide: added up and
/// compared with what is free before any of it is taken.
Status CudaSppm::reserve(const SppmParams& params, uint32_t room) {
    const size_t pixels = pixelCountOf(params);
    const Result<size_t> photonBytes = photons_.bytesWith(params.photonsPerPass, room);
    if (!photonBytes) { return photonBytes.error(); }
    const size_t needed = std::max(statistics_.bytes(), pixels * sizeof(SppmPixel)) +
                          std::max(pixels_.bytes(), pixels * sizeof(PassPixel)) + kSlices * kSliceBytes +
                          powerCdf_.bytes() + *photonBytes;
    if (needed > bytes()) {
        if (Status s = checkFits(device_, needsOf(params), needed, bytes()); !s) { return s; }
    }
    Status taken = takeMemory(params, room);
    if (!taken) {
        // Memory in pieces: what is left would only be in the way of the next attempt.
        const size_t held = bytes();
        for (DeviceBuffer* buffer : {&statistics_, &pixels_, &slices_}) {
            *buffer = {};
        }
        photons_ = DevicePhotons(device_);
        return Error{fmt::format("{} {:.1f} MiB, of which {:.1f} MiB could be taken: {}", needsOf(params),
                                 static_cast<double>(needed) / 1048576.0,
                                 static_cast<double>(held) / 1048576.0, taken.error().message),
                     {}};
    }
    return {};
}

Status CudaSppm::takeMemory(const SppmParams& params, uint32_t room) {
    const size_t pixels = pixelCountOf(params);
    if (Status s = statistics_.reserve(device_, pixels * sizeof(SppmPixel)); !s) { return s; }
    if (Status s = pixels_.reserve(device_, pixels * sizeof(PassPixel)); !s) { return s; }
    if (Status s = slices_.reserve(device_, kSlices * kSliceBytes); !s) { return s; }
    return photons_.reserve(params.photonsPerPass, room);
}

Status CudaSppm::uploadEmission(const SceneView& host) {
    if (power_) { return {}; }
    PowerDistribution table = buildPowerDistribution(host);
    const size_t bytes = table.cdf.size() * sizeof(float);
    if (bytes > 0) {
        if (Status s = powerCdf_.reserve(device_, bytes); !s) { return s; }
        if (Status s = device_.upload(powerCdf_.data(), table.cdf.data(), bytes); !s) { return s; }
    }
    power_ = std::move(table);
    return {};
}

Result<bool> CudaSppm::traceCamera(const Job& job) {
    const CameraLaunch launch{job.view, job.params, job.image, pixels_.as<PassPixel>()};
    return runPaced(device_, job.variant.camera, launch, job.pixelThreads(), job.stop, &cameraPacer_);
}

/// The grid around all visible points and their radii, and the cell sizes that gathering will ask for.
Status CudaSppm::findSpace(const Job& job, GridSpace* space, uint32_t* levelsInUse) {
    SpaceLaunch launch;
    launch.params = job.params;
    launch.statistics = statistics_.as<SppmPixel>();
    launch.pixels = pixels_.as<PassPixel>();
    launch.pixelCount = job.pixelCount();
    launch.slices = static_cast<uint32_t>(std::min<size_t>(kSlices, job.pixelCount()));
    launch.bounds = slices_.as<Bounds>();
    launch.levels = slices_.as<uint32_t>();

    std::vector<Bounds> bounds(launch.slices);
    if (Status s = runAtOnce(device_, kPhotonSteps.findBounds, launch, launch.slices); !s) { return s; }
    if (Status s = device_.download(bounds.data(), slices_.data(), bounds.size() * sizeof(Bounds)); !s) {
        return s;
    }
    Bounds all;
    for (const Bounds& slice : bounds) {
        all.grow(slice);
    }
    *space = launch.space = gridSpaceFor(all);

    std::vector<uint32_t> levels(launch.slices);
    if (Status s = runAtOnce(device_, kPhotonSteps.findLevels, launch, launch.slices); !s) { return s; }
    if (Status s = device_.download(levels.data(), slices_.data(), levels.size() * sizeof(uint32_t)); !s) {
        return s;
    }
    for (const uint32_t slice : levels) {
        *levelsInUse |= slice;
    }
    return {};
}

/// Again with more room where the photons of the pass turn out to be kept at more places than there was
/// room for.
Result<bool> CudaSppm::tracePhotons(const Job& job, const GridSpace& space, uint32_t* stored) {
    while (true) {
        const Result<PhotonSlots> slots = photons_.reset();
        if (!slots) { return slots.error(); }
        const PhotonLaunch launch{job.view, job.power, job.params, space, *slots};
        const Result<bool> done = runPaced(device_, job.variant.photons, launch, job.params.photonsPerPass,
                                           job.stop, &photonPacer_);
        if (!done || !*done) { return done; }
        const Result<uint64_t> wanted = photons_.wanted();
        if (!wanted) { return wanted.error(); }
        if (*wanted <= photons_.room()) {
            *stored = static_cast<uint32_t>(*wanted);
            return true;
        }
        if (Status s = PhotonStore::checkRoom(*wanted); !s) { return s.error(); }
        const uint64_t most = PhotonStore::kMaxPhotons;
        const auto room = static_cast<uint32_t>(std::min(*wanted + *wanted / 8, most));
        if (Status s = reserve(job.params, room); !s) { return s.error(); }
    }
}

Result<bool> CudaSppm::gather(const Job& job) {
    const GatherLaunch launch{job.view, job.params, photons_.grid(), statistics_.as<SppmPixel>(),
                              pixels_.as<PassPixel>()};
    return runPaced(device_, job.variant.gather, launch, job.pixelThreads(), job.stop, &gatherPacer_);
}

/// Updates the statistics and hands them out, all of them or none.
Status CudaSppm::commit(const Job& job, SppmState* state, std::vector<PixelSample>* direct) {
    const UpdateLaunch launch{job.params, pixels_.as<PassPixel>(), statistics_.as<SppmPixel>()};
    const size_t count = job.pixelCount();
    if (Status s = runAtOnce(device_, kPhotonSteps.update, launch, static_cast<uint32_t>(count)); !s) {
        return s;
    }
    try {
        fetched_.resize(count);
        direct->resize(count);
    } catch (const std::bad_alloc&) {
        return Error{"not enough memory for the statistics of a photon map", {}};
    }
    if (Status s = device_.download(fetched_.data(), statistics_.data(), count * sizeof(SppmPixel)); !s) {
        return s;
    }
    const auto* image = reinterpret_cast<const std::byte*>(job.image);
    if (Status s = device_.download(direct->data(), image, count * sizeof(PixelSample)); !s) { return s; }
    state->pixels.swap(fetched_);
    state->passes = job.params.pass.pass + 1;
    state->emittedPhotons += job.params.photonsPerPass;
    return {};
}

size_t CudaSppm::bytes() const {
    return statistics_.bytes() + pixels_.bytes() + slices_.bytes() + powerCdf_.bytes() + photons_.bytes();
}

}  // namespace glint
