// What the CUDA back end needs of a device: memory, copies, launches, sums and sorting. The seam that lets
// everything above it run in tests on a machine without a GPU.
//
// Implemented by gpu_device.cpp, and by the tests over host memory. A call per block, copy or launch, never
// per ray. Knows nothing of scenes.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "cuda/kernel.h"
#include "engine/base/result.h"

namespace glint {

/// Two device arrays of `count` keys: one to be sorted, one to work in.
struct KeySort {
    uint64_t* keys = nullptr;
    uint64_t* other = nullptr;
    uint32_t count = 0;
    int firstBit = 0;
    int endBit = 64;
};

/// Used by one thread at a time. Copies and waits see all launches before them finished.
class Device {
  public:
    virtual ~Device() = default;

    virtual std::string name() const = 0;
    virtual Result<size_t> freeBytes() const = 0;

    /// At least `bytes` (> 0) of device memory, aligned to kArrayAlignment. Error: there is not as much.
    virtual Result<std::byte*> allocate(size_t bytes) = 0;
    virtual void release(std::byte* block) = 0;

    virtual Status upload(std::byte* to, const void* from, size_t bytes) = 0;
    virtual Status download(void* to, const std::byte* from, size_t bytes) = 0;

    /// Zeroes, after all launches so far.
    virtual Status clear(std::byte* block, size_t bytes) = 0;

    /// Starts the kernel and returns at once.
    template <class Launch>
    Status launch(const Kernel<Launch>& kernel, const Launch& launch) {
        return start(kernel, &launch, launch.count);
    }
    /// Waits until no more than `pending` (0 or 1) launches are unfinished. Error: a launch has failed.
    virtual Status waitForLaunches(int pending) = 0;

    /// Working memory that is enough for sums over `sumCount` values and for `sort`, whose arrays
    /// don't matter.
    virtual Result<size_t> scratchBytes(uint32_t sumCount, const KeySort& sort) const = 0;
    /// Replaces each value by the sum of those before it.
    virtual Status sumBefore(uint32_t* values, uint32_t count, std::byte* scratch, size_t scratchBytes) = 0;
    /// Sorts by bits [firstBit, endBit), stably; both arrays are overwritten. Answers which of them holds
    /// the result.
    virtual Result<uint64_t*> sortKeys(const KeySort& sort, std::byte* scratch, size_t scratchBytes) = 0;

    /// Arrays in a block start at multiples of it: nodes are read in whole cache lines.
    static constexpr size_t kArrayAlignment = 256;

  protected:
    virtual Status start(const AnyKernel& kernel, const void* launch, uint32_t count) = 0;
};

/// The first GPU of this machine. Error: there is none, or its driver is too old; a clause without full stop.
Result<std::unique_ptr<Device>> openGpu();

}  // namespace glint
