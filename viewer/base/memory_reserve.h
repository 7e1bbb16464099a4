// Address space that is kept until something must not fail for want of memory. No page of it is ever touched,
// so it takes no memory but what a limit (ulimit -v) counts.
#pragma once

#include <cstddef>

#include <sys/mman.h>

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

}  // namespace glint
