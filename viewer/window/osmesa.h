// Mesa's off-screen renderer, opened when it is needed: a command that draws no window never loads it.
//
// Apart from the surface because <GL/osmesa.h> brings an old <GL/gl.h> that does not go together with
// core OpenGL's.
#pragma once

#include <memory>

#include "engine/base/result.h"

namespace glint {

inline constexpr const char* kOsMesaLibrary = "libOSMesa.so.8";

/// An OpenGL 3.3 core context that draws into memory, current on the thread that made it.
class OsMesaContext {
  public:
    using Proc = void (*)();

    /// Error: the library is missing or too old, or refuses the size.
    static Result<std::unique_ptr<OsMesaContext>> create(int width, int height);
    virtual ~OsMesaContext() = default;

    /// Usable without the object: what ImGui's loader is given.
    virtual Proc (*lookup() const)(const char*) = 0;
};

}  // namespace glint
