// A GPU behind the CUDA runtime. Every call is checked, and a failure becomes a message that says what
// was tried.

#include <array>

#include <cuda_runtime_api.h>
#include <fmt/format.h>

#include "cuda/device.h"
#include "cuda/gpu_algorithms.h"

namespace glint {
namespace {

Status checked(cudaError_t code, std::string_view what) {
    if (code == cudaSuccess) { return {}; }
    return Error{
        fmt::format("CUDA: {} failed: {} ({}).", what, cudaGetErrorString(code), cudaGetErrorName(code)), {}};
}

class GpuDevice final : public Device {
  public:
    explicit GpuDevice(const cudaDeviceProp& properties) : name_(properties.name) {}
    ~GpuDevice() override;

    Status open(int index);

    std::string name() const override { return name_; }
    Result<size_t> freeBytes() const override;
    Result<std::byte*> allocate(size_t bytes) override;
    void release(std::byte* block) override { cudaFree(block); }
    Status upload(std::byte* to, const void* from, size_t bytes) override;
    Status download(void* to, const std::byte* from, size_t bytes) override;
    Status clear(std::byte* block, size_t bytes) override;
    Status waitForLaunches(int pending) override;
    Result<size_t> scratchBytes(uint32_t sumCount, const KeySort& sort) const override;
    Status sumBefore(uint32_t* values, uint32_t count, std::byte* scratch, size_t scratchBytes) override;
    Result<uint64_t*> sortKeys(const KeySort& sort, std::byte* scratch, size_t scratchBytes) override;

  protected:
    Status start(const AnyKernel& kernel, const void* launch, uint32_t count) override;

  private:
    /// The current device belongs to the calling thread, which need not be the one that opened it.
    Status makeCurrent() const { return checked(cudaSetDevice(index_), "selecting the device"); }
    /// Marks the end of what was just started, or says why it was not.
    Status finishLaunch(int code, std::string_view what);
    Status copy(void* to, const void* from, size_t bytes, cudaMemcpyKind kind, std::string_view doing);

    std::string name_;
    int index_ = 0;
    cudaStream_t stream_ = nullptr;
    std::array<cudaEvent_t, 2> finished_{};  ///< the ends of the last two launches
    uint64_t launches_ = 0;
};

GpuDevice::~GpuDevice() {
    for (cudaEvent_t event : finished_) {
        if (event) { cudaEventDestroy(event); }
    }
    if (stream_) { cudaStreamDestroy(stream_); }
}

Status GpuDevice::open(int index) {
    index_ = index;
    if (Status s = checked(cudaSetDevice(index), "selecting the device"); !s) { return s; }
    if (Status s = checked(cudaStreamCreateWithFlags(&stream_, cudaStreamNonBlocking), "creating a stream");
        !s) {
        return s;
    }
    for (cudaEvent_t& event : finished_) {
        const unsigned flags = cudaEventDisableTiming | cudaEventBlockingSync;
        if (Status s = checked(cudaEventCreateWithFlags(&event, flags), "creating an event"); !s) {
            return s;
        }
    }
    return {};
}

Result<size_t> GpuDevice::freeBytes() const {
    size_t free = 0;
    size_t total = 0;
    if (Status s = makeCurrent(); !s) { return s.error(); }
    if (Status s = checked(cudaMemGetInfo(&free, &total), "asking for the free memory"); !s) {
        return s.error();
    }
    return free;
}

Result<std::byte*> GpuDevice::allocate(size_t bytes) {
    if (Status s = makeCurrent(); !s) { return s.error(); }
    void* block = nullptr;
    const cudaError_t code = cudaMalloc(&block, bytes);
    // An allocation that fails is no reason to fail the next call too.
    if (code != cudaSuccess) { cudaGetLastError(); }
    if (Status s = checked(code, fmt::format("allocating {} bytes", bytes)); !s) { return s.error(); }
    return static_cast<std::byte*>(block);
}

Status GpuDevice::upload(std::byte* to, const void* from, size_t bytes) {
    return copy(to, from, bytes, cudaMemcpyHostToDevice, "uploading");
}

Status GpuDevice::download(void* to, const std::byte* from, size_t bytes) {
    return copy(to, from, bytes, cudaMemcpyDeviceToHost, "downloading");
}

/// In the stream of the launches, which does not wait for copies outside of it: these may return before the
/// last bytes have reached the device.
Status GpuDevice::copy(void* to, const void* from, size_t bytes, cudaMemcpyKind kind,
                       std::string_view doing) {
    if (Status s = waitForLaunches(0); !s) { return s; }
    const std::string what = fmt::format("{} {} bytes", doing, bytes);
    if (Status s = checked(cudaMemcpyAsync(to, from, bytes, kind, stream_), what); !s) { return s; }
    return checked(cudaStreamSynchronize(stream_), what);
}

Status GpuDevice::finishLaunch(int code, std::string_view what) {
    if (Status s = checked(static_cast<cudaError_t>(code), what); !s) { return s; }
    return checked(cudaEventRecord(finished_[launches_++ % finished_.size()], stream_),
                   "marking a launch's end");
}

Status GpuDevice::start(const AnyKernel& kernel, const void* launch, uint32_t count) {
    if (count == 0) { return {}; }
    if (Status s = makeCurrent(); !s) { return s; }
    return finishLaunch(kernel.start(launch, stream_),
                        fmt::format("launching the kernel \"{}\" ({})", kernel.step, kernel.variant));
}

Status GpuDevice::clear(std::byte* block, size_t bytes) {
    if (Status s = makeCurrent(); !s) { return s; }
    return finishLaunch(cudaMemsetAsync(block, 0, bytes, stream_), fmt::format("clearing {} bytes", bytes));
}

Result<size_t> GpuDevice::scratchBytes(uint32_t sumCount, const KeySort& sort) const {
    size_t bytes = 0;
    if (Status s = makeCurrent(); !s) { return s.error(); }
    const auto code = static_cast<cudaError_t>(scratchBytesOnGpu(sumCount, sort, &bytes));
    if (Status s = checked(code, "asking for the working memory of sorting"); !s) { return s.error(); }
    return bytes;
}

Status GpuDevice::sumBefore(uint32_t* values, uint32_t count, std::byte* scratch, size_t scratchBytes) {
    if (Status s = makeCurrent(); !s) { return s; }
    return finishLaunch(sumBeforeOnGpu(values, count, scratch, scratchBytes, stream_),
                        fmt::format("summing {} values", count));
}

Result<uint64_t*> GpuDevice::sortKeys(const KeySort& sort, std::byte* scratch, size_t scratchBytes) {
    uint64_t* sorted = nullptr;
    if (Status s = makeCurrent(); !s) { return s.error(); }
    const int code = sortKeysOnGpu(sort, scratch, scratchBytes, stream_, &sorted);
    if (Status s = finishLaunch(code, fmt::format("sorting {} keys", sort.count)); !s) { return s.error(); }
    return sorted;
}

Status GpuDevice::waitForLaunches(int pending) {
    if (launches_ <= static_cast<uint64_t>(pending)) { return makeCurrent(); }
    const uint64_t last = launches_ - static_cast<uint64_t>(pending) - 1;
    return checked(cudaEventSynchronize(finished_[last % finished_.size()]), "rendering");
}

}  // namespace

Result<std::unique_ptr<Device>> openGpu() {
    int driver = 0;
    if (cudaDriverGetVersion(&driver) == cudaSuccess && driver == 0) {
        return Error{"no device was found, NVIDIA's driver is not installed", {}};
    }
    int count = 0;
    const cudaError_t code = cudaGetDeviceCount(&count);
    if (code == cudaErrorNoDevice || (code == cudaSuccess && count == 0)) {
        return Error{"no device was found", {}};
    }
    if (code != cudaSuccess) {
        return Error{fmt::format("no device can be used: {}", cudaGetErrorString(code)), {}};
    }
    cudaDeviceProp properties{};
    if (const Status s =
            checked(cudaGetDeviceProperties(&properties, 0), "asking for the device's properties");
        !s) {
        return s.error();
    }
    auto device = std::make_unique<GpuDevice>(properties);
    if (const Status s = device->open(0); !s) { return s.error(); }
    return std::unique_ptr<Device>(std::move(device));
}

}  // namespace glint
