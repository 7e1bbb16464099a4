#include "engine/io/scene_loader.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "engine/io/atomic_file.h"
#include "engine/io/file_kind.h"
#include "engine/io/importer.h"
#include "engine/io/scene_names.h"
#include "engine/scene/stability_warnings.h"

namespace glint {

Result<SceneDescription> loadScene(const std::string& path, const LoadOptions& options) {
    if (Status regular = checkRegularFile(path, "a scene file"); !regular) { return regular.error(); }
    const Importer* importer = importerOf(path, readHead(path));
    if (importer == nullptr) {
        return Error{fmt::format("is not a scene Glint knows; expected {}", listImporters()), {.file = path}};
    }
    auto scene = importer->load(path, options);
    if (scene) {
        makeNamesText(&*scene);
        std::vector<std::string> limits = stabilityWarnings(*scene);
        std::move(limits.begin(), limits.end(), std::back_inserter(scene->warnings));
    }
    return scene;
}

}  // namespace glint
