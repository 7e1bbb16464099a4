#include "viewer/window/surface.h"

#include <algorithm>

namespace glint {

std::vector<uint8_t> readSurface(const Surface& surface) {
    const GlApi& gl = surface.gl();
    const Vec2i size = surface.framebufferSize();
    const size_t rowBytes = static_cast<size_t>(size.x) * 3;
    std::vector<uint8_t> pixels(rowBytes * static_cast<size_t>(size.y));
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl.ReadPixels(0, 0, size.x, size.y, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
    // OpenGL's first row is the bottom one.
    for (int top = 0, bottom = size.y - 1; top < bottom; ++top, --bottom) {
        std::swap_ranges(pixels.begin() + static_cast<ptrdiff_t>(rowBytes) * top,
                         pixels.begin() + static_cast<ptrdiff_t>(rowBytes) * (top + 1),
                         pixels.begin() + static_cast<ptrdiff_t>(rowBytes) * bottom);
    }
    return pixels;
}

}  // namespace glint
