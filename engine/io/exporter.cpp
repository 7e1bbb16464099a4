#include "engine/io/exporter.h"

#include <fmt/format.h>

#include "engine/base/nearest_name.h"
#include "engine/io/file_kind.h"
#include "engine/io/scene_json.h"

namespace glint {
namespace {

Status saveJson(const SceneDescription& scene, const std::string& path, std::vector<std::string>*) {
    return saveSceneJson(scene, path);
}

bool isGlintJson(std::string_view head) { return head.find("\"glint\"") != std::string_view::npos; }

constexpr Exporter kExportJson{"Glint JSON", ".json", saveJson, isGlintJson};

}  // namespace

extern const Exporter kExportGltf, kExportMitsuba, kExportPbrt;

std::span<const Exporter> exporters() {
    static const Exporter kAll[] = {kExportJson, kExportGltf, kExportMitsuba, kExportPbrt};
    return kAll;
}

const Exporter* exporterOf(const std::string& path) { return kindByName(exporters(), path); }

std::string listExporters() {
    std::vector<std::string> kinds;
    for (const Exporter& exporter : exporters()) {
        kinds.push_back(fmt::format("{} ({})", exporter.name, exporter.extensions));
    }
    return joinNames(std::vector<std::string_view>(kinds.begin(), kinds.end()));
}

}  // namespace glint
