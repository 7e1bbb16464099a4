// The picture on the graphics card: a float texture of linear radiance, and its tone-mapped copy that ImGui
// draws; or that copy alone, of colours that are made elsewhere.
//
// Uploads happen only for new pictures, tone mapping only when something it depends on changed: an idle
// window costs nothing here, and an exposure edit never reaches the renderer.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/base/result.h"
#include "engine/render/tonemap.h"
#include "viewer/window/gl_api.h"

namespace glint {

class ImageDisplay {
  public:
    /// Error: a shader does not compile, with the driver's message.
    static Result<std::unique_ptr<ImageDisplay>> create(const GlApi& gl);
    ~ImageDisplay();
    ImageDisplay(const ImageDisplay&) = delete;
    ImageDisplay& operator=(const ImageDisplay&) = delete;

    /// 3 floats a pixel, row 0 at the top. `smooth`: magnified with interpolation (a preview), otherwise
    /// as squares.
    void upload(const float* rgb, int width, int height, bool smooth);
    /// Colours as the screen shows them, 4 bytes a pixel; the look does not touch them.
    void uploadColors(const uint8_t* rgba, int width, int height, bool smooth);

    /// Draws the tone-mapped copy if the radiance or the look is new.
    void update(const DisplayLook& look);

    /// Texture name of the tone-mapped copy; its first row is the picture's top row. 0 before the
    /// first upload.
    unsigned int texture() const { return width_ > 0 ? displayTexture_ : 0; }
    int width() const { return width_; }
    int height() const { return height_; }
    /// OpenGL runs on the processor: drawing a large picture would hold up the thread that draws.
    bool isSoftware() const { return isSoftware_; }
    /// The tone-mapped copy, 3 bytes a pixel, row 0 at the top: for tests.
    std::vector<uint8_t> readBack() const;

  private:
    explicit ImageDisplay(const GlApi& gl) : gl_(gl) {}
    Status init();
    /// Makes the copy of this size, and how it is magnified.
    void shape(int width, int height, bool smooth);

    GlApi gl_;
    unsigned int program_ = 0;
    unsigned int vertexArray_ = 0;
    unsigned int framebuffer_ = 0;
    unsigned int radianceTexture_ = 0;
    unsigned int displayTexture_ = 0;
    int exposureLocation_ = -1;
    int toneMapLocation_ = -1;
    int isNeutralLocation_ = -1;
    int balanceLocation_ = -1;
    int dithersLocation_ = -1;
    int width_ = 0;
    int height_ = 0;
    int radianceWidth_ = 0;  ///< of the float texture
    int radianceHeight_ = 0;
    bool isSoftware_ = false;
    bool stale_ = false;        ///< the float texture is newer than its copy
    bool hasRadiance_ = false;  ///< what is shown comes from the float texture
    DisplayLook look_;
};

}  // namespace glint
