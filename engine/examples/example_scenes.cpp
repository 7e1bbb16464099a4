#include "engine/examples/example_scenes.h"

#include <algorithm>
#include <array>

#include "engine/examples/cathedral.h"
#include "engine/examples/living_room.h"

namespace glint::examples {
namespace {

constexpr std::array<ExampleScene, 2> kScenes{{
    {"cathedral", "a vaulted nave, its lamps, and stained glass", writeCathedral},
    {"living-room", "a furnished room in the evening, warm lamps against a cool window", writeLivingRoom},
}};

}  // namespace

std::span<const ExampleScene> exampleScenes() { return kScenes; }

const ExampleScene* findExampleScene(std::string_view name) {
    const auto* found =
        std::find_if(kScenes.begin(), kScenes.end(), [&](const ExampleScene& s) { return s.name == name; });
    return found == kScenes.end() ? nullptr : found;
}

Result<uint64_t> writeExampleScene(const ExampleScene& scene, double detail, const std::string& folder,
                                   bool overwrite) {
    ExampleFolder to(folder, overwrite);
    if (to.status()) { scene.write(Detail{detail}, &to); }
    if (!to.status()) { return to.status().error(); }
    return to.triangles();
}

}  // namespace glint::examples
