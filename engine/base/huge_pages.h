// An allocator for large arrays that are read at random: asks the system for 2 MB pages, where it
// offers them.
//
// Used for acceleration structures, whose traversal otherwise spends its time on page table look-ups. Small
// arrays are allocated as usual.
#pragma once

#include <cstddef>
#include <vector>

namespace glint {

/// Memory for `bytes` with at least 64-byte alignment; throws std::bad_alloc as operator new does.
void* allocateHugePages(size_t bytes);
void freeHugePages(void* memory, size_t bytes) noexcept;

template <class T>
struct HugePageAllocator {
    using value_type = T;  // NOLINT(readability-identifier-naming): the allocator requirements' name
    static_assert(alignof(T) <= 64);

    HugePageAllocator() = default;
    template <class U>
    HugePageAllocator(const HugePageAllocator<U>&) {}

    T* allocate(size_t count) { return static_cast<T*>(allocateHugePages(count * sizeof(T))); }
    void deallocate(T* memory, size_t count) noexcept { freeHugePages(memory, count * sizeof(T)); }

    /// Plain resize() leaves elements unset, so that threads touch pages first where they fill them.
    template <class U>
    void construct(U* place) {
        ::new (static_cast<void*>(place)) U;
    }
    template <class U, class... Args>
    void construct(U* place, Args&&... args) {
        ::new (static_cast<void*>(place)) U(static_cast<Args&&>(args)...);
    }

    bool operator==(const HugePageAllocator&) const { return true; }
};

template <class T>
using HugeVector = std::vector<T, HugePageAllocator<T>>;

}  // namespace glint
