#include "viewer/window/gl_lookup.h"

#include <cstring>

namespace {

const char* headlessLibrary = nullptr;
glint::GlProcAddress headlessLookup = nullptr;

}  // namespace

namespace glint {

void setHeadlessLookup(const char* library, GlProcAddress lookup) {
    headlessLibrary = library;
    headlessLookup = lookup;
}

}  // namespace glint

// The names are the linker's.
// NOLINTBEGIN(bugprone-reserved-identifier)
extern "C" {

void* __real_dlopen(const char* file, int mode);
void* __real_dlsym(void* handle, const char* name);
void* __wrap_dlopen(const char* file, int mode);
void* __wrap_dlsym(void* handle, const char* name);

void* __wrap_dlopen(const char* file, int mode) {
    const bool wantsGl = file != nullptr && std::strncmp(file, "libGL.so", 8) == 0;
    return __real_dlopen(headlessLibrary != nullptr && wantsGl ? headlessLibrary : file, mode);
}

void* __wrap_dlsym(void* handle, const char* name) {
    if (headlessLookup != nullptr && std::strcmp(name, "glXGetProcAddressARB") == 0) {
        return reinterpret_cast<void*>(headlessLookup);
    }
    return __real_dlsym(handle, name);
}
}
// NOLINTEND(bugprone-reserved-identifier)
