#include "viewer/window/gl_api.h"

#include <fmt/format.h>

namespace glint {
namespace {

std::string driverName(const GlApi& gl) {
    const GLubyte* version = gl.GetString ? gl.GetString(GL_VERSION) : nullptr;
    return version ? fmt::format("OpenGL \"{}\"", reinterpret_cast<const char*>(version)) : "OpenGL";
}

}  // namespace

Result<GlApi> loadGlApi(const GlLookup& lookup) {
    GlApi gl;
#define GLINT_GL_LOAD(type, name)                                                              \
    gl.name = reinterpret_cast<type>(lookup("gl" #name));                                      \
    if (gl.name == nullptr) {                                                                  \
        return Error{fmt::format("{} has no gl{}; core 3.3 is needed", driverName(gl), #name), \
                     SourcePlace{}};                                                           \
    }
    GLINT_GL_FUNCTIONS(GLINT_GL_LOAD)
#undef GLINT_GL_LOAD
    return gl;
}

}  // namespace glint
