#include "engine/io/file_kind.h"
#include "engine/io/importer.h"
#include "engine/io/scene_json.h"
#include "engine/io/text_source.h"

namespace glint {
namespace {

bool looksLike(std::string_view head) {
    if (looksLikeGltf(head)) { return false; }
    std::string_view text = firstText(head);
    while (text.starts_with("//") || text.starts_with("/*")) {
        const std::string_view end = text[1] == '*' ? "*/" : "\n";
        const size_t at = text.find(end, 2);
        if (at == std::string_view::npos) { return true; }
        text = firstText(text.substr(at + end.size()));
    }
    return text.starts_with("{");
}

Result<SceneDescription> load(const std::string& path, const LoadOptions& options) {
    auto source = readSceneFile(path);
    return source ? readSceneJson(std::move(*source), options) : source.error();
}

}  // namespace

extern const Importer kImportJson;
const Importer kImportJson{
    .name = "Glint JSON",
    .extensions = ".json",
    .looksLike = looksLike,
    .load = load,
    .lights =
        "\"emission\" in the material of an object, \"lights\", or an \"environment\" that is not black"};

}  // namespace glint
