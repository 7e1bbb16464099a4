// The JSON schema of Glint's scene files, for editors that complete and check them: what the reader's lists
// of fields say, as text.
#pragma once

#include <string>

namespace glint {

/// The whole of scenes/glint.schema.json (JSON schema, draft 7).
std::string sceneSchema();

}  // namespace glint
