// The kinds of scene files that Glint writes. Whatever asks what can be written asks this table.
//
// A further kind is a file export_<name>.cpp that defines its Exporter, and a line in exporter.cpp.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/scene/scene.h"

namespace glint {

struct Exporter {
    std::string_view name;        ///< in messages
    std::string_view extensions;  ///< in lower case, with their dots, a blank apart
    /// Writes the scene to `path`, and beside it the files that it needs. What the format cannot express is
    /// appended to `warnings`. Error: a file cannot be written, or a part that was not read.
    Status (*save)(const SceneDescription& scene, const std::string& path,
                   std::vector<std::string>* warnings);
    /// Whether a file that begins so was written by Glint: others may be part of a scene.
    bool (*isOwn)(std::string_view head);
};

std::span<const Exporter> exporters();

/// Which one writes a file of that name; null: none.
const Exporter* exporterOf(const std::string& path);

/// "Glint JSON (.json) or …".
std::string listExporters();

}  // namespace glint
