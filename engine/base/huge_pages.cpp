// madvise() on Linux; elsewhere plain aligned memory.
#include "engine/base/huge_pages.h"

#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace glint {
namespace {

constexpr size_t kHugePage = size_t{1} << 21;

std::align_val_t alignmentFor(size_t bytes) { return std::align_val_t{bytes >= kHugePage ? kHugePage : 64}; }

}  // namespace

void* allocateHugePages(size_t bytes) {
    void* memory = ::operator new(bytes, alignmentFor(bytes));
#if defined(__linux__)
    // Only advice: where it is refused, ordinary pages do.
    if (bytes >= kHugePage) { madvise(memory, bytes, MADV_HUGEPAGE); }
#endif
    return memory;
}

void freeHugePages(void* memory, size_t bytes) noexcept {
    // Without the size: clang knows that form only with an option of its own.
    ::operator delete(memory, alignmentFor(bytes));
}

}  // namespace glint
