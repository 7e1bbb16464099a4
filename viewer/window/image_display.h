// The picture on the graphics card: a float texture of linear radiance, and its tone-mapped copy that ImGui
// draws.
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

    /// 3 floats a pixel, row 0 at the top. `smooth`: magnified with interpolation (a preview), otherwise as
    /// squares.
    void upload(const float* rgb, int width, int height, bool smooth);

    /// How the texture becomes display values.
    struct Look {
        float exposureStops = 0.0f;
        ToneMap toneMap = ToneMap::Srgb;
        bool displayValues = false;  ///< the texture holds display values already
        bool operator==(const Look&) const = default;
    };
    /// Draws the tone-mapped copy if the texture or the look is new.
    void update(const Look& look);

    /// Texture name of the tone-mapped copy; its first row is the picture's top row. 0 before the first
    /// upload.
    unsigned int texture() const { return width_ > 0 ? displayTexture_ : 0; }
    int width() const { return width_; }
    int height() const { return height_; }
    /// The tone-mapped copy, 3 bytes a pixel, row 0 at the top: for tests.
    std::vector<uint8_t> readBack() const;

  private:
    explicit ImageDisplay(const GlApi& gl) : gl_(gl) {}
    Status init();

    GlApi gl_;
    unsigned int program_ = 0;
    unsigned int vertexArray_ = 0;
    unsigned int framebuffer_ = 0;
    unsigned int radianceTexture_ = 0;
    unsigned int displayTexture_ = 0;
    int exposureLocation_ = -1;
    int toneMapLocation_ = -1;
    int width_ = 0;
    int height_ = 0;
    bool smooth_ = false;
    bool stale_ = false;
    Look look_;
};

}  // namespace glint
