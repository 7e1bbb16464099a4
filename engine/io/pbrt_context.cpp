#include "engine/io/pbrt_context.h"

#include <fmt/format.h>

namespace glint {

Error PbrtContext::errorAt(const PbrtPlace& at, std::string message) const {
    const PbrtFile& file = files[at.file];
    return {std::move(message),
            {file.path, static_cast<int>(at.line), static_cast<int>(at.column), file.text.lineText(at.line)}};
}

std::string PbrtContext::placeOf(const PbrtPlace& at) const {
    return fmt::format("{}:{}", files[at.file].path, at.line);
}

}  // namespace glint
