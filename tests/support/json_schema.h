// A validator for the part of JSON Schema draft-07 that scenes/glint.schema.json uses.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace glint::test {

/// The first thing in `value` that breaks `schema` (a sub-schema of `root`), as "path: what"; empty when it
/// is valid. A keyword that this validator does not know is reported too, so that none is silently ignored.
std::string schemaViolation(const nlohmann::json& root, const nlohmann::json& schema,
                            const nlohmann::json& value, const std::string& path);

}  // namespace glint::test
