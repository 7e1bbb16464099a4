// The ray casting kernel for the GPU.
#include "cuda/image_launch.cuh"
#include "cuda/preview_launch.h"

namespace glint {
namespace cuda_kernels {

struct CastRay {
    static GLINT_HD PixelSample pixel(const RayCastLaunch& launch, int x, int y) {
        return traceRayCast<kAllFeatures | kCompiledForGpu>(launch.view, launch.settings, launch.params, x,
                                                            y);
    }
};

}  // namespace cuda_kernels

const Kernel<RayCastLaunch> kCudaRayCast =
    cuda_kernels::makeKernel<cuda_kernels::EachPixel<cuda_kernels::CastRay>, RayCastLaunch>("ray casting",
                                                                                            "full");

}  // namespace glint
