// A row of the Materials panel that chooses an input's texture.
#pragma once

#include <string>
#include <vector>

#include "engine/math/material_inputs.h"
#include "viewer/model/scene_document.h"
#include "viewer/model/scene_files.h"

namespace glint {

/// What a row offers: none, the textures by their names or files, a file.
std::vector<std::string> textureChoices(const std::vector<Texture>& textures);

/// What the rows of a material need beside it. `material` counts the draft's.
struct TextureRows {
    SceneDocument* document;
    SceneFiles* files;
    size_t material;
    std::vector<std::string> choices;  ///< of every row: none, the draft's textures, a file

    TextureRows(SceneDocument* document, SceneFiles* files, size_t material);
    Material* of() const { return &document->draft().materials[material]; }
};

/// None, one of the scene's, or a file that becomes one. `chosen` is a texture index of the rows' material.
void drawTextureRow(const TextureRows& rows, const char* label, const char* tooltip, int* chosen);

/// Such a row for each input of the material's model that it looks at, but for its colour.
void drawModelTextures(const TextureRows& rows);

}  // namespace glint
