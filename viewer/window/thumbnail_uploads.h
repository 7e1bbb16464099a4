// Small pictures on the graphics card, for panels that list them (viewer/ui/thumbnail_textures.h).
#pragma once

#include "viewer/model/workspace.h"
#include "viewer/ui/thumbnail_textures.h"
#include "viewer/window/gl_api.h"

namespace glint {

class ThumbnailUploads {
  public:
    /// `gl` has to stay current until release().
    void create(const GlApi& gl);
    void release();
    /// Makes the textures that kept pictures, examples and the library's sheets lack, and gives up those that
    /// no list has any more.
    void update(const Workspace& workspace);

  private:
    unsigned int make(const Thumbnail& thumbnail) const;

    GlApi gl_;
    ui::TextureTable textures_;
};

}  // namespace glint
