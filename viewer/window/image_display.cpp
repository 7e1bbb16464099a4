#include "viewer/window/image_display.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "viewer/window/shader_sources.h"

namespace glint {
namespace {

Result<GLuint> compileShader(const GlApi& gl, GLenum kind, const char* name, const char* source) {
    const GLuint shader = gl.CreateShader(kind);
    gl.ShaderSource(shader, 1, &source, nullptr);
    gl.CompileShader(shader);
    GLint compiled = 0;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled) { return shader; }
    char log[1024] = "";
    gl.GetShaderInfoLog(shader, sizeof log, nullptr, log);
    gl.DeleteShader(shader);
    return Error{fmt::format("the driver rejects shaders/{}: {}", name, log), {}};
}

Result<GLuint> linkProgram(const GlApi& gl) {
    auto vertex = compileShader(gl, GL_VERTEX_SHADER, "fullscreen.vert", kFullscreenVertexShader);
    if (!vertex) { return vertex.error(); }
    auto fragment = compileShader(gl, GL_FRAGMENT_SHADER, "tonemap.frag", kToneMapFragmentShader);
    if (!fragment) {
        gl.DeleteShader(*vertex);
        return fragment.error();
    }
    const GLuint program = gl.CreateProgram();
    gl.AttachShader(program, *vertex);
    gl.AttachShader(program, *fragment);
    gl.LinkProgram(program);
    gl.DeleteShader(*vertex);
    gl.DeleteShader(*fragment);
    GLint linked = 0;
    gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked) { return program; }
    char log[1024] = "";
    gl.GetProgramInfoLog(program, sizeof log, nullptr, log);
    gl.DeleteProgram(program);
    return Error{fmt::format("the driver cannot link the tone-mapping shader: {}", log), {}};
}

/// Mesa's software drivers, and Microsoft's and Google's.
bool runsOnProcessor(const GlApi& gl) {
    const auto* text = reinterpret_cast<const char*>(gl.GetString(GL_RENDERER));
    const std::string_view name = text != nullptr ? text : "";
    constexpr std::array<std::string_view, 5> kRenderers{"llvmpipe", "softpipe", "swrast", "SwiftShader",
                                                         "GDI Generic"};
    return std::ranges::any_of(
        kRenderers, [&](std::string_view part) { return name.find(part) != std::string_view::npos; });
}

GLuint makeTexture(const GlApi& gl, GLint filter) {
    GLuint texture = 0;
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return texture;
}

}  // namespace

Result<std::unique_ptr<ImageDisplay>> ImageDisplay::create(const GlApi& gl) {
    std::unique_ptr<ImageDisplay> display(new ImageDisplay(gl));
    if (Status ready = display->init(); !ready) { return ready.error(); }
    return display;
}

Status ImageDisplay::init() {
    auto program = linkProgram(gl_);
    if (!program) { return program.error(); }
    program_ = *program;
    exposureLocation_ = gl_.GetUniformLocation(program_, "exposureStops");
    toneMapLocation_ = gl_.GetUniformLocation(program_, "toneMap");
    isNeutralLocation_ = gl_.GetUniformLocation(program_, "isNeutral");
    balanceLocation_ = gl_.GetUniformLocation(program_, "balance");
    dithersLocation_ = gl_.GetUniformLocation(program_, "dithers");
    gl_.GenVertexArrays(1, &vertexArray_);
    gl_.GenFramebuffers(1, &framebuffer_);
    radianceTexture_ = makeTexture(gl_, GL_NEAREST);
    displayTexture_ = makeTexture(gl_, GL_LINEAR);
    isSoftware_ = runsOnProcessor(gl_);
    return {};
}

ImageDisplay::~ImageDisplay() {
    const GLuint textures[] = {radianceTexture_, displayTexture_};
    gl_.DeleteTextures(2, textures);
    gl_.DeleteFramebuffers(1, &framebuffer_);
    gl_.DeleteVertexArrays(1, &vertexArray_);
    if (program_ != 0) { gl_.DeleteProgram(program_); }
}

void ImageDisplay::shape(int width, int height, bool smooth) {
    gl_.BindTexture(GL_TEXTURE_2D, displayTexture_);
    if (width != width_ || height != height_) {
        gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, displayTexture_, 0);
        gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
    }
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, smooth ? GL_LINEAR : GL_NEAREST);
    width_ = width;
    height_ = height;
}

void ImageDisplay::upload(const float* rgb, int width, int height, bool smooth) {
    gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl_.BindTexture(GL_TEXTURE_2D, radianceTexture_);
    if (width == radianceWidth_ && height == radianceHeight_) {
        gl_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGB, GL_FLOAT, rgb);
    } else {
        gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB32F, width, height, 0, GL_RGB, GL_FLOAT, rgb);
        radianceWidth_ = width;
        radianceHeight_ = height;
    }
    shape(width, height, smooth);
    gl_.BindTexture(GL_TEXTURE_2D, 0);
    stale_ = true;
    hasRadiance_ = true;
}

void ImageDisplay::uploadColors(const uint8_t* rgba, int width, int height, bool smooth) {
    gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    shape(width, height, smooth);
    gl_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
    gl_.BindTexture(GL_TEXTURE_2D, 0);
    hasRadiance_ = false;
}

void ImageDisplay::update(const DisplayLook& look) {
    if (!hasRadiance_ || (!stale_ && look == look_)) { return; }
    look_ = look;
    stale_ = false;
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl_.Viewport(0, 0, width_, height_);
    for (const GLenum state : {GL_BLEND, GL_DEPTH_TEST, GL_SCISSOR_TEST, GL_CULL_FACE}) {
        gl_.Disable(state);
    }
    gl_.UseProgram(program_);
    gl_.Uniform1f(exposureLocation_, look.exposureStops);
    gl_.Uniform1i(toneMapLocation_, static_cast<int>(look.toneMap));
    gl_.Uniform1i(isNeutralLocation_, look.white.isNeutral() ? 1 : 0);
    const Mat3 balance = whiteBalanceMatrix(look.white);
    gl_.UniformMatrix3fv(balanceLocation_, 1, GL_FALSE, &balance[0][0]);
    gl_.Uniform1i(dithersLocation_, look.dithers ? 1 : 0);
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_2D, radianceTexture_);
    gl_.BindVertexArray(vertexArray_);
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    gl_.BindVertexArray(0);
    gl_.BindTexture(GL_TEXTURE_2D, 0);
    gl_.UseProgram(0);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

std::vector<uint8_t> ImageDisplay::readBack() const {
    std::vector<uint8_t> bytes(static_cast<size_t>(width_) * static_cast<size_t>(height_) * 3);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl_.ReadPixels(0, 0, width_, height_, GL_RGB, GL_UNSIGNED_BYTE, bytes.data());
    gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
    return bytes;
}

}  // namespace glint
