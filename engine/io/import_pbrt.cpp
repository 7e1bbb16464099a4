// pbrt-v4 scenes, and those of version 3 where they are written alike. engine/io/README.md says what maps
// to what.
#include "engine/io/file_kind.h"
#include "engine/io/importer.h"
#include "engine/io/pbrt_reader.h"

namespace glint {
namespace {

Result<SceneDescription> load(const std::string& path, const LoadOptions& options) {
    return PbrtReader(path, options).read();
}

/// Or is packed.
bool looksLike(std::string_view head) {
    return head.starts_with("\x1f\x8b") ||
           (looksLikeText(head) && head.find("WorldBegin") != std::string_view::npos);
}

}  // namespace

extern const Importer kImportPbrt;
const Importer kImportPbrt{.name = "pbrt",
                           .extensions = ".pbrt .gz",
                           .looksLike = looksLike,
                           .load = load,
                           .lights = "a LightSource or an AreaLightSource"};

}  // namespace glint
