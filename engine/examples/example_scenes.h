// Scenes with many triangles, modelled and painted by code: too large to be kept as files.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "engine/examples/example_folder.h"
#include "engine/examples/model.h"

namespace glint::examples {

struct ExampleScene {
    std::string_view name;   ///< as on the command line
    std::string_view shows;  ///< in one line
    void (*write)(const Detail& detail, ExampleFolder* folder);
};

/// The table of them.
std::span<const ExampleScene> exampleScenes();

/// Null where there is none of that name.
const ExampleScene* findExampleScene(std::string_view name);

/// Writes `scene.json`, its meshes (PLY) and images (PNG) into a folder, which is made where it is missing:
/// the same bytes each time. `detail`: 1 as meant, with more than 500,000 triangles; less for quick tests.
/// Gives back the number of triangles. Error: the folder has files in it (unless `overwrite`), or cannot be
/// written to.
Result<uint64_t> writeExampleScene(const ExampleScene& scene, double detail, const std::string& folder,
                                   bool overwrite);

}  // namespace glint::examples
