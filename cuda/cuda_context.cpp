#include "cuda/cuda_context.h"

#include "cuda/device_memory.h"

namespace glint {

Status CudaContext::prepareImage(const PassParams& params, size_t sampleBytes) {
    if (scene.empty()) { return Error{"CUDA: there is no scene on the device to render.", {}}; }
    const size_t pixels = static_cast<size_t>(params.width) * static_cast<size_t>(params.height);
    if (pixels == 0) { return Error{"CUDA: the picture has no pixels.", {}}; }
    const size_t bytes = pixels * sampleBytes;
    if (image.bytes() >= bytes) { return {}; }
    if (Status s = checkFits(*device, "The picture needs", bytes, image.bytes()); !s) { return s; }
    return image.reserve(*device, bytes);
}

}  // namespace glint
