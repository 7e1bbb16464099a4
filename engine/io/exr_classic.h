// Reads OpenEXR channels through the C++ library: for what the C library of 3.1 does not unpack.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "engine/io/exr_file.h"

namespace glint {

/// As ExrFile::read(). Error: OpenEXR's message.
Status readByClassicLibrary(std::string_view bytes, const std::string& path, const ExrPart& part,
                            std::span<const ExrTarget> targets);

}  // namespace glint
