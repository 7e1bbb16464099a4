// Names from foreign files, which may be bytes of any kind, as text that every format can hold.
#pragma once

#include <string>
#include <string_view>

#include "engine/scene/scene.h"

namespace glint {

/// UTF-8: bytes that are none are taken for Latin-1, and a zero byte becomes U+FFFD.
std::string utf8Text(std::string_view bytes);

/// utf8Text() of all names, title and description. Paths stay as they are.
void makeNamesText(SceneDescription* scene);

}  // namespace glint
