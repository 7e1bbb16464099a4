// The kernel of ambient occlusion for the GPU.
#include "cuda/image_launch.cuh"
#include "cuda/preview_launch.h"
#include "engine/kernels/ambient_occlusion_kernel.h"

namespace glint {
namespace cuda_kernels {

struct SeeHowOpen {
    static GLINT_HD PixelSample pixel(const OcclusionLaunch& launch, int x, int y) {
        return traceAmbientOcclusion<kAllFeatures | kCompiledForGpu>(launch.view, launch.params,
                                                                     launch.radiusWorld, x, y);
    }
};

}  // namespace cuda_kernels

const Kernel<OcclusionLaunch> kCudaAmbientOcclusion =
    cuda_kernels::makeKernel<cuda_kernels::EachPixel<cuda_kernels::SeeHowOpen>, OcclusionLaunch>(
        "ambient occlusion", "full");

}  // namespace glint
