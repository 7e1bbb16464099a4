#include "engine/io/scene_loader.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "engine/io/atomic_file.h"
#include "engine/io/file_kind.h"
#include "engine/io/files_read.h"
#include "engine/io/foreign_kind.h"
#include "engine/io/importer.h"
#include "engine/io/remarks.h"
#include "engine/io/scene_names.h"
#include "engine/scene/scene_use.h"
#include "engine/scene/stability_warnings.h"

namespace glint {

Result<SceneDescription> loadScene(const std::string& path, const LoadOptions& options) {
    if (Status regular = checkRegularFile(path, "a scene file"); !regular) { return regular.error(); }
    const std::string head = readHead(path);
    const Importer* importer = importerOf(path, head);
    if (const auto foreign = foreignKindError(path, head, importer == nullptr)) { return *foreign; }
    if (importer == nullptr) {
        return Error{fmt::format("is not a scene Glint knows; expected {}", listImporters()), {.file = path}};
    }
    const FilesRead read;
    auto scene = importer->load(path, options);
    if (scene && !options.parameters.empty() && !importer->hasParameters) {
        scene->warnings.push_back(fmt::format("{}: {} has no parameters; \"{}\" sets nothing", path,
                                              importer->name, options.parameters.front().first));
    }
    if (scene && options.strict && !scene->warnings.empty()) {
        const size_t more = scene->warnings.size() - 1;
        return Error{fmt::format("{}{}; --strict refuses what is otherwise repaired", scene->warnings.front(),
                                 more > 0 ? fmt::format(" (and {} more warnings)", more) : ""),
                     {}};
    }
    if (scene) {
        scene->filesRead = read.paths();
        scene->readWith = {options.allowMissing, options.noStudio, options.parameters};
        makeNamesText(&*scene);
        std::vector<std::string> limits = stabilityWarnings(*scene);
        std::move(limits.begin(), limits.end(), std::back_inserter(scene->warnings));
        if (!hasLight(*scene)) {
            scene->warnings.push_back(fmt::format(
                "{}: nothing shines, so the picture stays black; expected {}", path, importer->lights));
        }
        boundLines(&scene->warnings);
        boundLines(&scene->notes);
    }
    return scene;
}

}  // namespace glint
