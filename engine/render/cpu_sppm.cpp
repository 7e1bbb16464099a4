// The stages of an SPPM pass as OpenMP loops.
#include "engine/render/cpu_sppm.h"

#include <algorithm>
#include <chrono>
#include <new>

#include "engine/base/parallel.h"
#include "engine/kernels/photon_surface.h"
#include "engine/kernels/sppm_pass_steps.h"

namespace glint {
namespace {

constexpr int kTileSize = 16;
constexpr uint64_t kPhotonsPerChunk = 1024;
constexpr int64_t kGatherPixels = 512;

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

struct CpuSppm::Job {
    const SceneView& view;
    const PowerDistributionView& power;
    const SppmParams& params;
    const SppmVariant& variant;
    const std::atomic<bool>& stop;
    SppmState* state;

    size_t pixelCount() const { return state->pixels.size(); }
    uint64_t chunkCount() const { return (params.photonsPerPass + kPhotonsPerChunk - 1) / kPhotonsPerChunk; }
};

bool CpuSppm::traceCamera(const Job& job, std::vector<PixelSample>* direct) {
    const int width = job.params.pass.width;
    const int height = job.params.pass.height;
    const int columns = (width + kTileSize - 1) / kTileSize;
    const int rows = (height + kTileSize - 1) / kTileSize;
    parallelChunks(int64_t{columns} * rows, 1, threads_, [&](int64_t tile, int64_t) {
        if (job.stop.load(std::memory_order_relaxed)) { return; }
        const int x = static_cast<int>(tile) % columns * kTileSize;
        const int y = static_cast<int>(tile) / columns * kTileSize;
        const PixelRect rect{x, y, std::min(x + kTileSize, width), std::min(y + kTileSize, height)};
        job.variant.traceVisiblePoints(job.view, job.params, rect, direct->data(), pixels_.data());
    });
    return !job.stop.load();
}

/// The grid around all visible points and their radii, and the cell sizes that gathering will ask for.
GridSpace CpuSppm::findSpace(const Job& job, uint32_t* levelsInUse) const {
    const auto slices = static_cast<size_t>(threads_);
    const SppmPixel* statistics = job.state->pixels.data();
    const auto forEachSlice = [&](auto&& visit) {
        parallelChunks(static_cast<int64_t>(slices), 1, threads_, [&](int64_t begin, int64_t) {
            const auto slice = static_cast<size_t>(begin);
            visit(slice,
                  PixelSlice{job.pixelCount() * slice / slices, job.pixelCount() * (slice + 1) / slices, 1});
        });
    };
    std::vector<Bounds> bounds(slices);
    forEachSlice([&](size_t slice, const PixelSlice& pixels) {
        bounds[slice] = searchBounds(job.params, statistics, pixels_.data(), pixels);
    });
    Bounds all;
    for (const Bounds& slice : bounds) {
        all.grow(slice);
    }
    const GridSpace space = gridSpaceFor(all);
    std::vector<uint32_t> levels(slices, 0);
    forEachSlice([&](size_t slice, const PixelSlice& pixels) {
        levels[slice] = searchLevels(job.params, space, statistics, pixels_.data(), pixels);
    });
    *levelsInUse = 0;
    for (const uint32_t own : levels) {
        *levelsInUse |= own;
    }
    return space;
}

Result<bool> CpuSppm::tracePhotons(const Job& job, const GridSpace& space) {
    const uint64_t first = uint64_t{job.params.pass.pass} * job.params.photonsPerPass;
    const uint64_t chunks = job.chunkCount();
    std::vector<PhotonTotals> totals(chunks);
    photonRoom_ = std::max<size_t>(photonRoom_, job.params.photonsPerPass);
    do {
        if (photons_.overflowed()) {
            const size_t wanted = photons_.wanted();
            const size_t most = PhotonStore::kMaxPhotons - chunks * PhotonStore::kBlockPhotons;
            photonRoom_ = std::max(wanted, std::min(wanted + wanted / 8, most));
        }
        if (Status s = PhotonStore::checkRoom(PhotonStore::roomFor(photonRoom_, chunks)); !s) {
            // The next pass may want less.
            photonRoom_ = 0;
            return s.error();
        }
        photons_.reset(photonRoom_, chunks);
        parallelChunks(static_cast<int64_t>(chunks), 1, threads_, [&](int64_t chunk, int64_t) {
            if (job.stop.load(std::memory_order_relaxed)) { return; }
            const uint64_t begin = first + static_cast<uint64_t>(chunk) * kPhotonsPerChunk;
            const uint64_t end = std::min(begin + kPhotonsPerChunk, first + job.params.photonsPerPass);
            const auto index = static_cast<size_t>(chunk);
            totals[index] = job.variant.tracePhotons(job.view, job.power, job.params, {begin, end}, space,
                                                     &photons_.writer(index));
        });
    } while (photons_.overflowed() && !job.stop.load());
    stats_.photons = {};
    for (const PhotonTotals& chunk : totals) {
        stats_.photons.emitted += chunk.emitted;
        stats_.photons.escaped += chunk.escaped;
        stats_.photons.rays += chunk.rays;
        stats_.photons.faulty += chunk.faulty;
    }
    return !job.stop.load();
}

bool CpuSppm::gather(const Job& job) {
    const auto gatherWith = [&](const auto& photons, const auto& loop) {
        parallelChunks(static_cast<int64_t>(job.pixelCount()), kGatherPixels, threads_,
                       [&](int64_t begin, int64_t end) {
                           if (!job.stop.load(std::memory_order_relaxed)) {
                               loop(job.view, photons, job.params, job.state->pixels.data(),
                                    static_cast<size_t>(begin), static_cast<size_t>(end), pixels_.data());
                           }
                       });
    };
    if (job.params.lookup == PhotonLookupKind::Tree) {
        gatherWith(photons_.tree(), job.variant.gatherFromTree);
    } else {
        gatherWith(photons_.grid(), job.variant.gatherFromGrid);
    }
    return !job.stop.load();
}

void CpuSppm::update(const Job& job) {
    parallelChunks(static_cast<int64_t>(job.pixelCount()), 16384, threads_, [&](int64_t begin, int64_t end) {
        for (auto i = static_cast<size_t>(begin); i < static_cast<size_t>(end); ++i) {
            commitPixel(job.params, pixels_[i].gathered, &job.state->pixels[i]);
        }
    });
    job.state->passes = job.params.pass.pass + 1;
    job.state->emittedPhotons += job.params.photonsPerPass;
}

Result<bool> CpuSppm::renderPass(const SceneView& view, FeatureMask features,
                                 const PowerDistributionView& power, const SppmParams& params,
                                 const std::atomic<bool>& stop, SppmState* state,
                                 std::vector<PixelSample>* direct) {
    const SppmVariant& variant = chooseVariant(sppmVariants(), features, params.pass.sampler);
    const SppmParams settled = settledParams(view, params);
    const Job job{view, power, settled, variant, stop, state};
    using Clock = std::chrono::steady_clock;
    try {
        direct->resize(job.pixelCount());
        pixels_.resize(job.pixelCount());

        auto start = Clock::now();
        if (!traceCamera(job, direct)) { return false; }
        stats_.cameraSeconds = secondsSince(start);

        start = Clock::now();
        uint32_t levelsInUse = 0;
        const GridSpace space = findSpace(job, &levelsInUse);
        if (Result<bool> traced = tracePhotons(job, space); !traced || !*traced) { return traced; }
        stats_.photonSeconds = secondsSince(start);

        start = Clock::now();
        if (params.lookup == PhotonLookupKind::Tree) {
            photons_.buildTree(threads_);
        } else {
            photons_.buildGrid(space, levelsInUse, threads_);
        }
        stats_.sortSeconds = secondsSince(start);

        start = Clock::now();
        if (!gather(job)) { return false; }
        update(job);
        stats_.gatherSeconds = secondsSince(start);
    } catch (const std::bad_alloc&) {
        return Error{"not enough memory for the photons of a pass; fewer photons per pass need less", {}};
    }
    stats_.storedPhotons = photons_.photonCount();
    stats_.photonBytes = photons_.bytes();
    return true;
}

}  // namespace glint
