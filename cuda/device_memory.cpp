#include "cuda/device_memory.h"

#include <fmt/format.h>

namespace glint {

Status checkFits(const Device& device, std::string_view what, size_t bytes, size_t held) {
    const Result<size_t> free = device.freeBytes();
    if (!free) { return free.error(); }
    const size_t available = free.value() + held;
    if (bytes <= available) { return {}; }
    const auto mebibytes = [](size_t n) { return static_cast<double>(n) / (1024.0 * 1024.0); };
    return Error{fmt::format("{} {:.1f} MiB on {}, but only {:.1f} MiB are free there.", what,
                             mebibytes(bytes), device.name(), mebibytes(available)),
                 {}};
}

}  // namespace glint
