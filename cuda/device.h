// What the CUDA back end needs of a device: memory, copies and launches. The seam that lets everything above
// it run in tests on a machine without a GPU.
//
// Implemented by gpu_device.cpp, and by the tests over host memory. A call per block, copy or launch, never
// per ray. Knows nothing of scenes.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "cuda/cuda_variant.h"
#include "engine/base/result.h"

namespace glint {

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

    /// Start a part of a pass and return at once.
    virtual Status launchPath(const CudaVariant& variant, const PathLaunch& launch) = 0;
    virtual Status launchAov(const CudaVariant& variant, const AovLaunch& launch) = 0;
    /// Waits until no more than `pending` (0 or 1) launches are unfinished. Error: a launch has failed.
    virtual Status waitForLaunches(int pending) = 0;

    /// Arrays in a block start at multiples of it: nodes are read in whole cache lines.
    static constexpr size_t kArrayAlignment = 256;
};

/// The first GPU of this machine. Error: there is none, or its driver is too old; a clause without full stop.
Result<std::unique_ptr<Device>> openGpu();

}  // namespace glint
