// A kernel as plain C++ sees it: how to start it on a GPU and how to run it on the host.
//
// Made in .cu files by kernel_launch.cuh, started by a Device. No CUDA header is named here.
#pragma once

#include <cstdint>

namespace glint {

/// The runtime's cudaStream_t.
using GpuStream = void*;

/// `launch` points to the plain struct that the kernel is given by value, which has the members `first` and
/// `count`: the kernel's threads [first, first + count) do one element each.
struct AnyKernel {
    const char* step = "";     ///< what it does: "path", "photons"
    const char* variant = "";  ///< the feature mask it is compiled for; empty where none matters
    /// Answers the runtime's cudaError_t, 0 when started.
    int (*start)(const void* launch, GpuStream stream) = nullptr;
    /// Runs elements [begin, end) of [0, count) with the very bodies of the kernel, compiled in the same
    /// translation unit, over pointers that are the host's.
    void (*runOnHost)(const void* launch, uint32_t begin, uint32_t end) = nullptr;
};

template <class Launch>
struct Kernel : AnyKernel {};

}  // namespace glint
