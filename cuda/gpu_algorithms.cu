// CUB behind plain functions. CUB's radix sort is stable and, given two buffers, needs little more memory.
#include <algorithm>

#include <cub/device/device_radix_sort.cuh>
#include <cub/device/device_scan.cuh>

#include "cuda/gpu_algorithms.h"

namespace glint {

int scratchBytesOnGpu(uint32_t sumCount, const KeySort& sort, size_t* bytes) {
    size_t sumBytes = 0;
    size_t sortBytes = 0;
    uint32_t* const values = nullptr;
    cub::DoubleBuffer<uint64_t> keys;
    if (const cudaError_t code = cub::DeviceScan::ExclusiveSum(nullptr, sumBytes, values, values, sumCount)) {
        return code;
    }
    if (const cudaError_t code = cub::DeviceRadixSort::SortKeys(nullptr, sortBytes, keys, sort.count,
                                                                sort.firstBit, sort.endBit)) {
        return code;
    }
    *bytes = std::max({sumBytes, sortBytes, size_t{1}});
    return cudaSuccess;
}

int sumBeforeOnGpu(uint32_t* values, uint32_t count, std::byte* scratch, size_t scratchBytes,
                   GpuStream stream) {
    return cub::DeviceScan::ExclusiveSum(scratch, scratchBytes, values, values, count,
                                         static_cast<cudaStream_t>(stream));
}

int sortKeysOnGpu(const KeySort& sort, std::byte* scratch, size_t scratchBytes, GpuStream stream,
                  uint64_t** sorted) {
    cub::DoubleBuffer<uint64_t> keys(sort.keys, sort.other);
    const cudaError_t code =
        cub::DeviceRadixSort::SortKeys(scratch, scratchBytes, keys, sort.count, sort.firstBit, sort.endBit,
                                       static_cast<cudaStream_t>(stream));
    *sorted = keys.Current();
    return code;
}

}  // namespace glint
