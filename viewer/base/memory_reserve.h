// Address space that is kept until something must not fail for want of memory. No page of it is ever touched,
// so it takes no memory but what a limit (ulimit -v) counts.
#pragma once

#include <cstddef>

#include <sys/mman.h>

#include "engine/render/checkpoint.h"

namespace glint {

class MemoryReserve {
  public:
    explicit MemoryReserve(size_t bytes)
        : place_(::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE,
                        -1, 0)),
          bytes_(bytes) {}
    ~MemoryReserve() { release(); }
    MemoryReserve(const MemoryReserve&) = delete;
    MemoryReserve& operator=(const MemoryReserve&) = delete;

    /// False when there was not so much, and after release().
    bool isHeld() const { return place_ != MAP_FAILED; }
    void release() {
        if (isHeld()) { ::munmap(place_, bytes_); }
        place_ = MAP_FAILED;
    }

  private:
    void* place_;
    size_t bytes_;
};

/// What saving a picture and a checkpoint takes at most: a copy of the film, and its forms on the way into
/// a file.
inline size_t bytesToSave(const SceneDescription& scene, bool hasLayers) {
    const Resolution& size = scene.resolution;
    const size_t pixels = static_cast<size_t>(size.width) * static_cast<size_t>(size.height);
    const size_t bytesPerPixel = hasLayers ? 500 : 100;
    return 2 * checkpointBytes(size.width, size.height, scene.options.integrator) + bytesPerPixel * pixels +
           (size_t{16} << 20);
}

}  // namespace glint
