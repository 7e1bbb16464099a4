// The few things that every HTML report needs.
#pragma once

#include <string>
#include <string_view>

namespace glint {

/// For text and quoted attributes; not valid UTF-8 and control characters become U+FFFD.
std::string htmlText(std::string_view text);

/// RFC 4648, section 4.
std::string base64(std::string_view bytes);

}  // namespace glint
