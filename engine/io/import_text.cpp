#include "engine/io/file_kind.h"
#include "engine/io/importer.h"
#include "engine/io/scene_text.h"
#include "engine/io/text_source.h"

namespace glint {
namespace {

bool looksLike(std::string_view head) {
    const std::string_view text = firstText(head);
    for (const std::string_view block :
         {"PerspectiveCamera", "Background", "Lights", "DiskLights", "Materials", "Group"}) {
        if (text.starts_with(block)) { return true; }
    }
    return false;
}

Result<SceneDescription> load(const std::string& path, const LoadOptions& options) {
    auto source = readSceneFile(path);
    return source ? readSceneText(std::move(*source), options) : source.error();
}

}  // namespace

extern const Importer kImportText;
const Importer kImportText{
    .name = "6.837 text",
    .extensions = ".txt",
    .looksLike = looksLike,
    .load = load,
    .lights = "'emission' in the material of an object, a Lights block, or a Background that is not black"};

}  // namespace glint
