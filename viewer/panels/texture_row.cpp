#include "viewer/panels/texture_row.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "engine/scene/scene_use.h"
#include "viewer/model/image_choice.h"
#include "viewer/panels/input_words.h"
#include "viewer/ui/widgets.h"

namespace glint {
namespace {

void askForFile(const TextureRows& rows, const int* chosen) {
    const std::vector<int*> inputs = inputTextures(rows.of());
    const auto input = static_cast<size_t>(std::ranges::find(inputs, chosen) - inputs.begin());
    rows.files->dialog.ask(
        {"Choose an image", rows.files->opened, false,
         [document = rows.document, material = rows.material, input](const std::string& path) {
             chooseTextureFile(document, material, input, path);
         }});
}

}  // namespace

std::vector<std::string> textureChoices(const std::vector<Texture>& textures) {
    std::vector<std::string> choices{"none"};
    for (size_t i = 0; i < textures.size(); ++i) {
        const std::string path = pathOf(textures[i].image.source);
        choices.push_back(!textures[i].name.empty() ? textures[i].name
                          : !path.empty()           ? path
                                                    : fmt::format("texture {}", i));
    }
    choices.emplace_back("From a file…");
    return choices;
}

TextureRows::TextureRows(SceneDocument* ofDocument, SceneFiles* ofFiles, size_t ofMaterial)
    : document(ofDocument),
      files(ofFiles),
      material(ofMaterial),
      choices(textureChoices(ofDocument->draft().textures)) {}

void drawTextureRow(const TextureRows& rows, const char* label, const char* tooltip, int* chosen) {
    const std::vector<std::string_view> views(rows.choices.begin(), rows.choices.end());
    int index = *chosen + 1;
    if (!ui::choice(label, &index, views, tooltip)) { return; }
    if (static_cast<size_t>(index) + 1 == views.size()) {
        askForFile(rows, chosen);
    } else {
        *chosen = index - 1;
    }
}

void drawModelTextures(const TextureRows& rows) {
    Material* material = rows.of();
    forEachModelInput(
        [&](const InputInfo& info, auto& input) {
            if (!looksAt(*material, info)) { return; }
            drawTextureRow(rows, (inputLabel(info.key) + " map").c_str(), "An image that replaces the number",
                           &input.texture);
        },
        *material);
}

}  // namespace glint
