#include "viewer/window/thumbnail_textures.h"

#include <algorithm>

namespace glint {

unsigned int ThumbnailTextures::make(const Thumbnail& thumbnail) const {
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

void ThumbnailTextures::update(std::vector<KeptPicture>* kept) {
    std::erase_if(textures_, [&](const auto& each) {
        const bool isKept = std::ranges::find(*kept, each.first, &KeptPicture::number) != kept->end();
        if (!isKept) { gl_.DeleteTextures(1, &each.second); }
        return !isKept;
    });
    for (KeptPicture& each : *kept) {
        if (each.texture == 0) { each.texture = textures_[each.number] = make(each.thumbnail); }
    }
}

template <class Listed>
void ThumbnailTextures::makeMissing(std::vector<Listed>* listed) {
    for (Listed& each : *listed) {
        if (each.texture != 0 || each.thumbnail.rgba.empty()) { continue; }
        lasting_.push_back(each.texture = make(each.thumbnail));
    }
}

void ThumbnailTextures::update(std::vector<ExampleScene>* examples) { makeMissing(examples); }

void ThumbnailTextures::update(std::vector<PresetSheet>* sheets) { makeMissing(sheets); }

void ThumbnailTextures::release() {
    for (const unsigned int texture : lasting_) {
        gl_.DeleteTextures(1, &texture);
    }
    lasting_.clear();
    for (const auto& [number, texture] : textures_) {
        gl_.DeleteTextures(1, &texture);
    }
    textures_.clear();
}

}  // namespace glint
