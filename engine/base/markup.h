// Text within HTML and XML.
#pragma once

#include <string>
#include <string_view>

namespace glint {

/// With the five characters escaped that mean something in markup, for text and quoted attributes.
std::string escapedMarkup(std::string_view text);

}  // namespace glint
