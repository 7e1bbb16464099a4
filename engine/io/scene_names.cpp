#include "engine/io/scene_names.h"

#include <algorithm>

namespace glint {
namespace {

/// Bytes of the character that `bytes` begin with, as RFC 3629 has it; 0: none.
size_t characterLength(std::string_view bytes) {
    const auto at = [bytes](size_t i) { return static_cast<unsigned char>(bytes[i]); };
    const unsigned lead = at(0);
    if (lead < 0x80) { return 1; }
    const size_t length = lead >= 0xc2 && lead < 0xe0   ? 2
                          : lead >= 0xe0 && lead < 0xf0 ? 3
                          : lead >= 0xf0 && lead < 0xf5 ? 4
                                                        : 0;
    if (length == 0 || bytes.size() < length) { return 0; }
    for (size_t i = 1; i < length; ++i) {
        if ((at(i) & 0xc0) != 0x80) { return 0; }
    }
    // Longer forms than needed, surrogates, and what lies beyond U+10FFFF.
    const unsigned second = at(1);
    const bool isForbidden = (lead == 0xe0 && second < 0xa0) || (lead == 0xed && second >= 0xa0) ||
                             (lead == 0xf0 && second < 0x90) || (lead == 0xf4 && second >= 0x90);
    return isForbidden ? 0 : length;
}

}  // namespace

std::string utf8Text(std::string_view bytes) {
    std::string text;
    while (!bytes.empty()) {
        const size_t length = characterLength(bytes);
        if (bytes[0] == '\0') {
            text += "\xef\xbf\xbd";
        } else if (length > 0) {
            text += bytes.substr(0, length);
        } else {
            const auto code = static_cast<unsigned char>(bytes[0]);
            text += static_cast<char>(0xc0 | code >> 6);
            text += static_cast<char>(0x80 | (code & 0x3f));
        }
        bytes.remove_prefix(std::max<size_t>(length, 1));
    }
    return text;
}

void makeNamesText(SceneDescription* scene) {
    const auto clean = [](std::string* name) { *name = utf8Text(*name); };
    clean(&scene->title);
    clean(&scene->description);
    std::ranges::for_each(scene->textures, [&](Texture& texture) { clean(&texture.name); });
    std::ranges::for_each(scene->materials, [&](Material& material) { clean(&material.name); });
    std::ranges::for_each(scene->meshes, [&](Mesh& mesh) { clean(&mesh.name); });
    std::ranges::for_each(scene->objects, [&](Object& object) { clean(&object.name); });
    std::ranges::for_each(scene->hiddenObjects, [&](Object& object) { clean(&object.name); });
    std::ranges::for_each(scene->lights, [&](Light& light) { clean(&light.name); });
}

}  // namespace glint
