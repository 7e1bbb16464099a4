// Passes on a device: uploads the scene, launches a pass in parts, and brings its samples back.

#include "cuda/cuda_backend.h"

#include <optional>
#include <utility>

#include <fmt/format.h>

#include "cuda/cuda_sppm.h"
#include "cuda/cuda_variant.h"
#include "cuda/device_buffer.h"
#include "cuda/device_memory.h"
#include "cuda/device_scene.h"
#include "cuda/paced_launches.h"
#include "engine/render/sppm_integrator.h"
#include "engine/render/variant_choice.h"

namespace glint {
namespace {

class CudaBackend final : public Backend {
  public:
    explicit CudaBackend(std::unique_ptr<Device> device) : device_(std::move(device)), scene_(*device_) {}

    std::string name() const override { return "CUDA, " + device_->name(); }

    std::string kernelName(SamplerKind sampler) const override {
        return scene_.empty() ? "" : chooseVariant(cudaVariants(), features_, sampler).name;
    }

    Status setScene(std::shared_ptr<const BuiltScene> scene) override {
        features_ = scene->features;
        host_ = scene;
        if (sppm_) { sppm_->sceneChanged(); }
        Status taken = scene_.update(scene);
        if (taken || !sppm_) { return taken; }
        // Photons are kept from pass to pass only to be faster.
        sppm_.reset();
        return scene_.update(std::move(scene));
    }

    Result<Integrator*> integrator(IntegratorKind kind) override;

    Result<bool> renderAovPass(const PassParams& params, const std::atomic<bool>& stop,
                               std::vector<AovSample>* out) override {
        return render(params, stop, &CudaVariant::aov, &aovPacer_, out);
    }

    Result<bool> renderPaths(const PassParams& params, const std::atomic<bool>& stop,
                             std::vector<PixelSample>* out) {
        return render(params, stop, &CudaVariant::path, &pathPacer_, out);
    }

    Result<bool> renderPhotons(const SppmParams& params, const std::atomic<bool>& stop, SppmState* state,
                               std::vector<PixelSample>* direct);

  private:
    class Paths;
    class Photons;

    template <class Sample>
    Result<bool> render(const PassParams& params, const std::atomic<bool>& stop,
                        Kernel<ImageLaunch<Sample>> CudaVariant::*kernel, ChunkPacer* pacer,
                        std::vector<Sample>* out);
    Status prepare(const PassParams& params, size_t sampleBytes);
    Status reserveImage(size_t bytes);

    std::unique_ptr<Device> device_;
    DeviceScene scene_;
    std::shared_ptr<const BuiltScene> host_;
    DeviceBuffer image_;  ///< the samples of a pass, of either kind; grows as needed
    FeatureMask features_ = 0;
    ChunkPacer pathPacer_;
    ChunkPacer aovPacer_;
    std::optional<CudaSppm> sppm_;  ///< made by the first SPPM pass
    std::unique_ptr<Integrator> paths_;
    std::unique_ptr<Integrator> photons_;
};

class CudaBackend::Paths final : public Integrator {
  public:
    explicit Paths(CudaBackend* backend) : backend_(backend) {}

    Result<bool> renderPass(const PassParams& params, const std::atomic<bool>& stop, ImageStatistics*,
                            std::vector<PixelSample>* samples) override {
        return backend_->renderPaths(params, stop, samples);
    }

  private:
    CudaBackend* backend_;
};

class CudaBackend::Photons final : public SppmIntegrator {
  public:
    explicit Photons(CudaBackend* backend) : backend_(backend) {}

  protected:
    Result<bool> renderPhotons(const SppmParams& params, const std::atomic<bool>& stop, SppmState* state,
                               std::vector<PixelSample>* direct) override {
        return backend_->renderPhotons(params, stop, state, direct);
    }

  private:
    CudaBackend* backend_;
};

Result<Integrator*> CudaBackend::integrator(IntegratorKind kind) {
    if (kind == IntegratorKind::PathTracing) {
        if (!paths_) { paths_ = std::make_unique<Paths>(this); }
        return paths_.get();
    }
    if (kind == IntegratorKind::Sppm) {
        if (!photons_) { photons_ = std::make_unique<Photons>(this); }
        return photons_.get();
    }
    return Error{fmt::format("CUDA has no kernels for {}: choose another integrator, or render on the CPU.",
                             integratorInfo(kind).key),
                 {}};
}

template <class Sample>
Result<bool> CudaBackend::render(const PassParams& params, const std::atomic<bool>& stop,
                                 Kernel<ImageLaunch<Sample>> CudaVariant::*kernel, ChunkPacer* pacer,
                                 std::vector<Sample>* out) {
    if (Status s = prepare(params, sizeof(Sample)); !s) { return s.error(); }
    const CudaVariant& variant = chooseVariant(cudaVariants(), features_, params.sampler);
    const ImageLaunch<Sample> launch{scene_.view(), params, image_.as<Sample>()};
    const uint32_t threads = threadsOfPass(params.width, params.height);
    const Result<bool> done = runPaced(*device_, variant.*kernel, launch, threads, stop, pacer);
    if (!done || !*done) { return done; }
    out->resize(static_cast<size_t>(params.width) * static_cast<size_t>(params.height));
    if (Status s = device_->download(out->data(), image_.data(), out->size() * sizeof(Sample)); !s) {
        return s.error();
    }
    return true;
}

Result<bool> CudaBackend::renderPhotons(const SppmParams& params, const std::atomic<bool>& stop,
                                        SppmState* state, std::vector<PixelSample>* direct) {
    if (Status s = prepare(params.pass, sizeof(PixelSample)); !s) { return s.error(); }
    if (!sppm_) { sppm_.emplace(*device_); }
    const SceneView host = host_->view();
    return sppm_->renderPass({scene_.view(), host, features_}, params, stop, image_.as<PixelSample>(), state,
                             direct);
}

/// Whether there is something to render, and memory for its samples.
Status CudaBackend::prepare(const PassParams& params, size_t sampleBytes) {
    if (scene_.empty()) { return Error{"CUDA: there is no scene on the device to render.", {}}; }
    const size_t pixels = static_cast<size_t>(params.width) * static_cast<size_t>(params.height);
    if (pixels == 0) { return Error{"CUDA: the picture has no pixels.", {}}; }
    return reserveImage(pixels * sampleBytes);
}

Status CudaBackend::reserveImage(size_t bytes) {
    if (image_.bytes() >= bytes) { return {}; }
    if (Status s = checkFits(*device_, "The picture needs", bytes, image_.bytes()); !s) { return s; }
    return image_.reserve(*device_, bytes);
}

}  // namespace

Result<std::unique_ptr<Backend>> makeCudaBackend() {
    Result<std::unique_ptr<Device>> device = openGpu();
    if (!device) { return device.error(); }
    return makeCudaBackend(std::move(*device));
}

std::unique_ptr<Backend> makeCudaBackend(std::unique_ptr<Device> device) {
    return std::make_unique<CudaBackend>(std::move(device));
}

}  // namespace glint
