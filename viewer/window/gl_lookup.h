// Answers Dear ImGui's search for libGL with libOSMesa while there is no display.
//
// ImGui's OpenGL 3 back end finds its functions with dlopen("libGL.so.1") and dlsym("glXGetProcAddressARB"),
// which know nothing of an OSMesa context. The program is linked with --wrap=dlopen,--wrap=dlsym; only these
// two look-ups are ever answered differently, and only after setHeadlessLookup().
#pragma once

#include "viewer/window/gl_api.h"

namespace glint {

using GlProcAddress = GlProc (*)(const char* name);

/// `library` is the file name to open instead of libGL. Both null: look-ups go to the system again.
void setHeadlessLookup(const char* library, GlProcAddress lookup);

}  // namespace glint
