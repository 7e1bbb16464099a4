// Where the viewer draws and what its events come from: a window, or memory when there is no display.
//
// The application, the panels and the session are the same on both. A surface owns the OpenGL context and
// prepares Dear ImGui's input for a frame; it knows nothing of scenes.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/math/vec.h"
#include "viewer/window/gl_api.h"

namespace glint {

class Surface {
  public:
    virtual ~Surface() = default;

    virtual const GlApi& gl() const = 0;
    /// Sleeps until an event arrives or `seconds` have passed.
    virtual void waitEvents(double seconds) = 0;
    /// Sets ImGuiIO's display size, time step and input for the coming frame.
    virtual void beginFrame() = 0;
    /// Shows what was drawn.
    virtual void present() = 0;
    virtual bool shouldClose() const = 0;
    /// The user has to answer first.
    virtual void refuseClose() = 0;
    /// True once after input arrived from outside; the application then draws a few frames without pause.
    virtual bool takeInputFlag() = 0;

    /// Files that were dropped on the window since the last call.
    virtual std::vector<std::string> takeDroppedFiles() = 0;

    /// Physical pixels.
    virtual Vec2i framebufferSize() const = 0;
    /// Physical pixels per unit of a 96-dpi design: 1 on ordinary screens, 2 on high-density ones.
    virtual float contentScale() const = 0;
    /// Physical pixels per ImGui unit: 1 except where the window system scales coordinates by itself.
    virtual float framebufferScale() const = 0;
    virtual void setTitle(const std::string& title) = 0;
    virtual bool hasDisplay() const = 0;
};

struct SurfaceOptions {
    int width = 1280;
    int height = 720;
    float contentScale = 0.0f;  ///< 0: the screen's
};

/// A window on the display. Error: no display, or no OpenGL 3.3; the message names the cause.
Result<std::unique_ptr<Surface>> makeWindowSurface(const SurfaceOptions& options);

/// Memory, drawn by OSMesa in this process; needs no display. Error: libOSMesa is missing or refuses
/// the context.
Result<std::unique_ptr<Surface>> makeHeadlessSurface(const SurfaceOptions& options);

/// What is on the surface now, 3 bytes a pixel, row 0 at the top.
std::vector<uint8_t> readSurface(const Surface& surface);

}  // namespace glint
