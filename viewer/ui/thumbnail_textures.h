// Which textures hold the thumbnails of lists. Panels ask by thumbnail; whoever owns OpenGL makes
// the textures.
#pragma once

#include <cstdint>
#include <map>

namespace glint::ui {

/// By the thumbnails' ids.
using TextureTable = std::map<uint64_t, unsigned int>;

/// What textureOf() looks into, until the next call; null: nothing.
void useTextures(const TextureTable* table);
/// 0: there is none yet.
unsigned int textureOf(uint64_t thumbnailId);

}  // namespace glint::ui
