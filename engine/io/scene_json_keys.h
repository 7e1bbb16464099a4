// Every kind of object in a Glint JSON scene and the keys it takes: what the reader knows and the schema
// must list.
//
// The reader looks kinds up here and cannot read a key that is not listed; a test compares the table with
// scenes/glint.schema.json, whose definitions have the same names.
#pragma once

#include <span>
#include <string_view>

namespace glint {

struct JsonKind {
    std::string_view name;  ///< name of the schema's definition; "scene" is the root
    std::span<const std::string_view> keys;
};

std::span<const JsonKind> sceneJsonKinds();

/// The keys of one kind, which must exist.
std::span<const std::string_view> sceneJsonKeys(std::string_view kind);

}  // namespace glint
