# Turns shaders/* into one C++ source, so that the program runs from anywhere. A changed shader configures anew.
# Sets embedded_shaders to the source's path. The declarations are in window/shader_sources.h.

file(READ ${PROJECT_SOURCE_DIR}/shaders/fullscreen.vert FULLSCREEN_VERT)
file(READ ${PROJECT_SOURCE_DIR}/shaders/tonemap.frag TONEMAP_FRAG)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
    ${PROJECT_SOURCE_DIR}/shaders/fullscreen.vert ${PROJECT_SOURCE_DIR}/shaders/tonemap.frag)
set(embedded_shaders ${CMAKE_CURRENT_BINARY_DIR}/shader_sources.cpp)
file(CONFIGURE OUTPUT ${embedded_shaders} @ONLY CONTENT [==[
#include "viewer/window/shader_sources.h"

namespace glint {

const char* const kFullscreenVertexShader = R"glsl(@FULLSCREEN_VERT@)glsl";
const char* const kToneMapFragmentShader = R"glsl(@TONEMAP_FRAG@)glsl";

}  // namespace glint
]==])
