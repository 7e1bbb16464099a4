// The shaders of shaders/, embedded by viewer/embed_shaders.cmake.
#pragma once

namespace glint {

extern const char* const kFullscreenVertexShader;
extern const char* const kToneMapFragmentShader;

}  // namespace glint
