// Linux gives every thread its own nice value, although POSIX says that it belongs to the process.
#include "engine/base/thread_priority.h"

#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace glint {

void lowerThreadPriority() {
    constexpr int kNice = 10;
    const auto thread = static_cast<id_t>(syscall(SYS_gettid));
    // The result is not of interest: without the right to it, the render is merely less polite.
    (void)setpriority(PRIO_PROCESS, thread, kNice);
}

}  // namespace glint
