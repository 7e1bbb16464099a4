#include "viewer/ui/thumbnail_textures.h"

namespace glint::ui {
namespace {

const TextureTable* tableInUse = nullptr;

}  // namespace

void useTextures(const TextureTable* table) { tableInUse = table; }

unsigned int textureOf(uint64_t thumbnailId) {
    if (tableInUse == nullptr) { return 0; }
    const auto found = tableInUse->find(thumbnailId);
    return found != tableInUse->end() ? found->second : 0;
}

}  // namespace glint::ui
