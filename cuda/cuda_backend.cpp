// Passes on a device: uploads the scene, launches a pass in parts, and brings its samples back.

#include "cuda/cuda_backend.h"

#include <chrono>
#include <utility>

#include <fmt/format.h>

#include "cuda/chunk_pacer.h"
#include "cuda/device_buffer.h"
#include "cuda/device_scene.h"

namespace glint {
namespace {

double secondsNow() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

FeatureMask featuresOfPass(const PassParams& params) {
    return params.sampler == SamplerTag::Independent ? FeatureMask{kFeatureIndependentSampler} : 0;
}

class CudaBackend final : public Backend {
  public:
    explicit CudaBackend(std::unique_ptr<Device> device) : device_(std::move(device)), scene_(*device_) {}

    std::string name() const override { return "CUDA, " + device_->name(); }

    std::string kernelName() const override {
        return scene_.empty() ? "" : chooseCudaVariant(features_).name;
    }

    Status setScene(std::shared_ptr<const BuiltScene> scene) override {
        features_ = scene->features;
        return scene_.update(std::move(scene));
    }

    Result<bool> renderPass(const PassParams& params, const std::atomic<bool>& stop,
                            std::vector<PixelSample>* out) override {
        const auto launch = [this](const CudaVariant& v, const PathLaunch& l) {
            return device_->launchPath(v, l);
        };
        return render(params, stop, launch, &pathPacer_, out);
    }

    Result<bool> renderAovPass(const PassParams& params, const std::atomic<bool>& stop,
                               std::vector<AovSample>* out) override {
        const auto launch = [this](const CudaVariant& v, const AovLaunch& l) {
            return device_->launchAov(v, l);
        };
        return render(params, stop, launch, &aovPacer_, out);
    }

  private:
    template <class Sample, class StartLaunch>
    Result<bool> render(const PassParams& params, const std::atomic<bool>& stop,
                        const StartLaunch& startLaunch, ChunkPacer* pacer, std::vector<Sample>* out);
    Status reserveImage(size_t bytes);

    std::unique_ptr<Device> device_;
    DeviceScene scene_;
    DeviceBuffer image_;  ///< the samples of a pass, of either kind; grows as needed
    FeatureMask features_ = 0;
    ChunkPacer pathPacer_;
    ChunkPacer aovPacer_;
};

template <class Sample, class StartLaunch>
Result<bool> CudaBackend::render(const PassParams& params, const std::atomic<bool>& stop,
                                 const StartLaunch& startLaunch, ChunkPacer* pacer,
                                 std::vector<Sample>* out) {
    if (scene_.empty()) return Error{"CUDA: there is no scene on the device to render.", {}};
    const size_t pixels = static_cast<size_t>(params.width) * static_cast<size_t>(params.height);
    if (pixels == 0) return Error{"CUDA: the picture has no pixels.", {}};
    if (Status s = reserveImage(pixels * sizeof(Sample)); !s) return s.error();

    const CudaVariant& variant = chooseCudaVariant(features_ | featuresOfPass(params));
    Launch<Sample> launch{scene_.view(), params, reinterpret_cast<Sample*>(image_.data()), 0, 0};
    const uint32_t threads = threadsOfPass(params.width, params.height);
    double lastEnd = secondsNow();
    uint32_t running = 0;
    // The launch before is waited for while the next one already runs.
    const auto waitForRunning = [&](int pending) -> Status {
        if (Status s = device_->waitForLaunches(pending); !s) return s;
        const double end = secondsNow();
        if (running != 0) pacer->measured(running, end - std::exchange(lastEnd, end));
        return {};
    };
    while (launch.first < threads && !stop.load(std::memory_order_relaxed)) {
        launch.count = std::min(pacer->threads(), threads - launch.first);
        if (Status s = startLaunch(variant, launch); !s) return s.error();
        if (Status s = waitForRunning(1); !s) return s.error();
        running = launch.count;
        launch.first += launch.count;
    }
    if (Status s = waitForRunning(0); !s) return s.error();
    if (launch.first < threads) return false;
    out->resize(pixels);
    if (Status s = device_->download(out->data(), image_.data(), pixels * sizeof(Sample)); !s)
        return s.error();
    return true;
}

Status CudaBackend::reserveImage(size_t bytes) {
    if (image_.bytes() >= bytes) return {};
    image_ = {};
    Result<size_t> free = device_->freeBytes();
    if (!free) return free.error();
    if (bytes > *free) {
        return Error{fmt::format("The picture needs {} bytes on {}, but only {} are free there.", bytes,
                                 device_->name(), *free),
                     {}};
    }
    Result<DeviceBuffer> buffer = DeviceBuffer::allocate(*device_, bytes);
    if (!buffer) return buffer.error();
    image_ = std::move(*buffer);
    return {};
}

}  // namespace

Result<std::unique_ptr<Backend>> makeCudaBackend() {
    Result<std::unique_ptr<Device>> device = openGpu();
    if (!device) return device.error();
    return makeCudaBackend(std::move(*device));
}

std::unique_ptr<Backend> makeCudaBackend(std::unique_ptr<Device> device) {
    return std::make_unique<CudaBackend>(std::move(device));
}

}  // namespace glint
