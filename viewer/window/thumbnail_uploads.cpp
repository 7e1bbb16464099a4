#include "viewer/window/thumbnail_uploads.h"

#include <utility>
#include <vector>

namespace glint {
namespace {

std::vector<const Thumbnail*> listedIn(const Workspace& workspace) {
    std::vector<const Thumbnail*> all;
    const auto add = [&all](const Thumbnail& thumbnail) {
        if (!thumbnail.rgba.empty()) { all.push_back(&thumbnail); }
    };
    for (const KeptRender& each : workspace.snapshots.kept()) {
        add(each.thumbnail);
    }
    for (const ExampleScene& each : workspace.examples.scenes) {
        add(each.thumbnail);
    }
    for (const PresetSheet& each : workspace.presets.sheets) {
        add(each.thumbnail);
    }
    return all;
}

}  // namespace

void ThumbnailUploads::create(const GlApi& gl) {
    gl_ = gl;
    ui::useTextures(&textures_);
}

unsigned int ThumbnailUploads::make(const Thumbnail& thumbnail) const {
    GLuint texture = 0;
    gl_.GenTextures(1, &texture);
    gl_.BindTexture(GL_TEXTURE_2D, texture);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
        gl_.TexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
    }
    gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, thumbnail.width, thumbnail.height, 0, GL_RGBA,
                   GL_UNSIGNED_BYTE, thumbnail.rgba.data());
    gl_.BindTexture(GL_TEXTURE_2D, 0);
    return texture;
}

void ThumbnailUploads::update(const Workspace& workspace) {
    ui::TextureTable before = std::exchange(textures_, {});
    for (const Thumbnail* each : listedIn(workspace)) {
        const auto made = before.extract(each->id);
        textures_[each->id] = made.empty() ? make(*each) : made.mapped();
    }
    for (const auto& [id, texture] : before) {
        gl_.DeleteTextures(1, &texture);
    }
}

void ThumbnailUploads::release() {
    ui::useTextures(nullptr);
    for (const auto& [id, texture] : textures_) {
        gl_.DeleteTextures(1, &texture);
    }
    textures_.clear();
}

}  // namespace glint
