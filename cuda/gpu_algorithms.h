// Prefix sums and sorting on a GPU, by CUB.
#pragma once

#include "cuda/device.h"

namespace glint {

// All answer the runtime's cudaError_t and return before the work is done. See Device for what they do.
int scratchBytesOnGpu(uint32_t sumCount, const KeySort& sort, size_t* bytes);
int sumBeforeOnGpu(uint32_t* values, uint32_t count, std::byte* scratch, size_t scratchBytes,
                   GpuStream stream);
int sortKeysOnGpu(const KeySort& sort, std::byte* scratch, size_t scratchBytes, GpuStream stream,
                  uint64_t** sorted);

}  // namespace glint
