// A CUDA device made of host memory: it runs the bodies of the kernels, as nvcc compiled them for the host,
// over a scene in the uploaded layout. So everything of cuda/ but gpu_device.cpp runs on a machine without a
// GPU.
//
// Header only, since it exists only where glint_cuda does.
#pragma once

#include <cstdlib>
#include <cstring>
#include <functional>
#include <map>

#include "cuda/device.h"

namespace glint::test {

/// What a test sees and decides; shared with the device, which the back end owns.
struct HostDeviceControl {
    size_t memoryBytes = size_t{1} << 30;
    std::map<const std::byte*, size_t> blocks{};  ///< taken at the moment
    int allocations = 0;
    int uploads = 0;
    size_t uploadedBytes = 0;
    int launches = 0;
    std::string lastVariant{};
    int failLaunch = -1;                  ///< the n-th launch from now on fails
    std::function<void()> onLaunch = {};  ///< called after each launch

    size_t taken() const {
        size_t sum = 0;
        for (const auto& [block, bytes] : blocks) sum += bytes;
        return sum;
    }
    /// Whether [pointer, pointer + bytes) lies in one block.
    bool holds(const void* pointer, size_t bytes) const {
        const auto* begin = static_cast<const std::byte*>(pointer);
        auto after = blocks.upper_bound(begin);
        if (after == blocks.begin()) return false;
        const auto& [block, size] = *std::prev(after);
        return begin + bytes <= block + size;
    }
};

class HostDevice final : public Device {
  public:
    explicit HostDevice(std::shared_ptr<HostDeviceControl> control) : control_(std::move(control)) {}

    std::string name() const override { return "host memory"; }
    Result<size_t> freeBytes() const override { return control_->memoryBytes - control_->taken(); }

    Result<std::byte*> allocate(size_t bytes) override {
        if (bytes > *freeBytes()) return Error{"the test device is full", {}};
        const size_t rounded = (bytes + kArrayAlignment - 1) / kArrayAlignment * kArrayAlignment;
        auto* block = static_cast<std::byte*>(std::aligned_alloc(kArrayAlignment, rounded));
        std::memset(block, kPoison, rounded);
        control_->blocks[block] = bytes;
        ++control_->allocations;
        return block;
    }
    void release(std::byte* block) override {
        // A pointer into memory that was given back must not find the old values.
        std::memset(block, kPoison, control_->blocks.at(block));
        control_->blocks.erase(block);
        std::free(block);
    }

    Status upload(std::byte* to, const void* from, size_t bytes) override {
        if (!control_->holds(to, bytes)) return Error{"upload outside the blocks", {}};
        std::memcpy(to, from, bytes);
        ++control_->uploads;
        control_->uploadedBytes += bytes;
        return {};
    }
    Status download(void* to, const std::byte* from, size_t bytes) override {
        if (!control_->holds(from, bytes)) return Error{"download outside the blocks", {}};
        std::memcpy(to, from, bytes);
        return {};
    }

    Status launchPath(const CudaVariant& variant, const PathLaunch& launch) override {
        return run(variant, launch, variant.runPathOnHost);
    }
    Status launchAov(const CudaVariant& variant, const AovLaunch& launch) override {
        return run(variant, launch, variant.runAovOnHost);
    }
    Status waitForLaunches(int) override { return {}; }

  private:
    static constexpr int kPoison = 0xcd;

    template <class AnyLaunch>
    Status run(const CudaVariant& variant, const AnyLaunch& launch, void (*body)(const AnyLaunch&)) {
        if (control_->failLaunch-- == 0) return Error{"the test device failed", {}};
        control_->lastVariant = variant.name;
        ++control_->launches;
        body(launch);
        if (control_->onLaunch) control_->onLaunch();
        return {};
    }

    std::shared_ptr<HostDeviceControl> control_;
};

}  // namespace glint::test
