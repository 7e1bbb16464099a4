// A CUDA device made of host memory: it runs the bodies of the kernels, as nvcc compiled them for the host,
// over a scene in the uploaded layout. So everything of cuda/ but gpu_device.cpp runs on a machine without
// a GPU.
//
// Header only, since it exists only where glint_cuda does.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <map>
#include <numeric>
#include <thread>
#include <vector>

#include "cuda/device.h"

namespace glint::test {

/// How the threads of a launch run: one after the other, or neighbours on several of the host's at once.
enum class ThreadOrder { Forwards, Backwards, AtOnce };

/// What a test sees and decides; shared with the device, which the back end owns.
struct HostDeviceControl {
    size_t memoryBytes = size_t{1} << 30;
    std::map<const std::byte*, size_t> blocks{};  ///< taken at the moment
    int allocations = 0;
    int uploads = 0;
    size_t uploadedBytes = 0;
    int launches = 0;
    std::map<std::string, uint64_t> threadsOf{};  ///< launched so far, by step
    std::string lastStep{};
    std::string lastVariant{};
    int failLaunch = -1;      ///< the n-th launch from now on fails
    int failAllocation = -1;  ///< the same, although there is enough memory
    ThreadOrder order = ThreadOrder::Forwards;
    bool sortIntoOther = false;           ///< sorting leaves its result in the other array
    std::function<void()> onLaunch = {};  ///< called after each launch

    size_t taken() const {
        size_t sum = 0;
        for (const auto& [block, bytes] : blocks) {
            sum += bytes;
        }
        return sum;
    }
    /// Whether [pointer, pointer + bytes) lies in one block.
    bool holds(const void* pointer, size_t bytes) const {
        const auto* begin = static_cast<const std::byte*>(pointer);
        auto after = blocks.upper_bound(begin);
        if (after == blocks.begin()) { return false; }
        const auto& [block, size] = *std::prev(after);
        return begin + bytes <= block + size;
    }
};

class HostDevice final : public Device {
  public:
    explicit HostDevice(std::shared_ptr<HostDeviceControl> control) : control_(std::move(control)) {}

    std::string name() const override { return "host memory"; }
    Result<size_t> freeBytes() const override {
        return control_->memoryBytes - std::min(control_->memoryBytes, control_->taken());
    }

    Result<std::byte*> allocate(size_t bytes) override {
        if (control_->failAllocation-- == 0) { return Error{"the test device is in pieces", {}}; }
        if (bytes > *freeBytes()) { return Error{"the test device is full", {}}; }
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
        if (!control_->holds(to, bytes)) { return Error{"upload outside the blocks", {}}; }
        std::memcpy(to, from, bytes);
        ++control_->uploads;
        control_->uploadedBytes += bytes;
        return {};
    }
    Status download(void* to, const std::byte* from, size_t bytes) override {
        if (!control_->holds(from, bytes)) { return Error{"download outside the blocks", {}}; }
        std::memcpy(to, from, bytes);
        return {};
    }

    Status clear(std::byte* block, size_t bytes) override {
        if (!control_->holds(block, bytes)) { return Error{"clearing outside the blocks", {}}; }
        std::memset(block, 0, bytes);
        return {};
    }
    Status waitForLaunches(int) override { return {}; }

    Result<size_t> scratchBytes(uint32_t sumCount, const KeySort& sort) const override {
        return size_t{sumCount} / 8 + sort.count / 8 + 1;
    }
    Status sumBefore(uint32_t* values, uint32_t count, std::byte* scratch, size_t bytes) override {
        if (!useScratch(scratch, bytes, *scratchBytes(count, {}))) {
            return Error{"too little to work in", {}};
        }
        std::exclusive_scan(values, values + count, values, uint32_t{0});
        return {};
    }
    Result<uint64_t*> sortKeys(const KeySort& sort, std::byte* scratch, size_t bytes) override {
        if (!useScratch(scratch, bytes, *scratchBytes(0, sort))) {
            return Error{"too little to work in", {}};
        }
        if (!control_->holds(sort.keys, sort.count * sizeof(uint64_t)) ||
            !control_->holds(sort.other, sort.count * sizeof(uint64_t))) {
            return Error{"sorting outside the blocks", {}};
        }
        const int bits = sort.endBit - sort.firstBit;
        const uint64_t mask = bits < 64 ? (uint64_t{1} << bits) - 1 : ~uint64_t{0};
        const auto digits = [&](uint64_t key) { return key >> sort.firstBit & mask; };
        std::stable_sort(sort.keys, sort.keys + sort.count,
                         [&](uint64_t a, uint64_t b) { return digits(a) < digits(b); });
        // A GPU's result lies in either array, and the other holds nothing of use.
        if (!control_->sortIntoOther) {
            std::memset(sort.other, kPoison, sort.count * sizeof(uint64_t));
            return sort.keys;
        }
        std::copy_n(sort.keys, sort.count, sort.other);
        std::memset(sort.keys, kPoison, sort.count * sizeof(uint64_t));
        return sort.other;
    }

  protected:
    Status start(const AnyKernel& kernel, const void* launch, uint32_t count) override {
        if (control_->failLaunch-- == 0) { return Error{"the test device failed", {}}; }
        control_->lastStep = kernel.step;
        control_->lastVariant = kernel.variant;
        ++control_->launches;
        control_->threadsOf[kernel.step] += count;
        runThreads(kernel, launch, count);
        if (control_->onLaunch) { control_->onLaunch(); }
        return {};
    }

  private:
    static constexpr int kPoison = 0xcd;

    void runThreads(const AnyKernel& kernel, const void* launch, uint32_t count) const {
        switch (control_->order) {
            case ThreadOrder::Forwards:
                kernel.runOnHost(launch, 0, count);
                break;
            case ThreadOrder::Backwards:
                for (uint32_t i = count; i-- > 0;) {
                    kernel.runOnHost(launch, i, i + 1);
                }
                break;
            case ThreadOrder::AtOnce:
                constexpr uint32_t kThreads = 4;
                std::vector<std::thread> threads;
                for (uint32_t t = 0; t < kThreads; ++t) {
                    threads.emplace_back([&, t] {
                        for (uint32_t i = t; i < count; i += kThreads) {
                            kernel.runOnHost(launch, i, i + 1);
                        }
                    });
                }
                for (std::thread& thread : threads) {
                    thread.join();
                }
                break;
        }
    }

    bool useScratch(std::byte* scratch, size_t bytes, size_t needed) {
        if (bytes < needed || !control_->holds(scratch, bytes)) { return false; }
        std::memset(scratch, kPoison, bytes);
        return true;
    }

    std::shared_ptr<HostDeviceControl> control_;
};

}  // namespace glint::test
