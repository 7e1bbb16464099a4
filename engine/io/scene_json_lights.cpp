// Glint JSON: lights without a shape, and the environment.
#include <fmt/format.h>

#include "engine/io/scene_json_fields.h"

namespace glint {
void SceneJsonReader::readLights(const JsonValue& value) {
    if (!value.present() || !expectType(errors_, value, "lights", JsonType::Array)) { return; }
    forEachItem(errors_, value, [&](const JsonValue& item, size_t number) {
        Light light = readLight(item);
        if (light.name.empty()) { light.name = fmt::format("light {}", number + 1); }
        scene_.lights.push_back(std::move(light));
    });
}

Light SceneJsonReader::readLight(const JsonValue& value) {
    Light light;
    const std::optional<LightKind> kind = kindOf<LightKind>(value, "light");
    if (!kind) { return light; }
    readFields(fieldsOf(value, nameOf(*kind), fieldKeys<Light>(only(*kind))), only(*kind), &light);
    return light;
}

void SceneJsonReader::readEnvironment(const JsonValue& value) {
    if (!value.present()) { return; }
    const JsonFields fields = fieldsOf(value, "environment", fieldKeys<Environment>());
    scene_.environment.color = Vec3(1.0f);
    readFields(fields, ~0u, &scene_.environment);
    if (const JsonValue image = fields.find("image"); image.present()) { readEnvironmentImage(image); }
}

void SceneJsonReader::readEnvironmentImage(const JsonValue& value) {
    if (errors_.failed() || !expectType(errors_, value, "image", JsonType::Object)) { return; }
    bool isSky = false;
    forEachMember(errors_, value,
                  [&](const std::string& key, const JsonValue&) { isSky |= key == "generator"; });
    SceneImage image;
    if (isSky) {
        image.source = readSky(value);
        if (errors_.failed()) { return; }
        environmentPlace_ = value;
    } else {
        const JsonFields fields = fieldsOf(value, "image", formKeys("environmentFile"));
        const JsonValue file = fields.require("file");
        FileSource named;
        fields.string("file", &named.path);
        image.source = named;
        if (errors_.failed()) { return; }
        environmentPlace_ = file;
    }
    scene_.environment.image = static_cast<int>(scene_.environmentImages.size());
    scene_.environmentImages.push_back(std::move(image));
}

SkySource SceneJsonReader::readSky(const JsonValue& value) {
    std::vector<std::string_view> keys = fieldKeys<SkySource>();
    keys.insert(keys.begin(), "generator");
    const JsonFields fields = fieldsOf(value, "sky", std::move(keys));
    SkySource sky;
    fields.word("generator", std::array<std::string_view, 1>{"sky"});
    readFields(fields, ~0u, &sky);
    return sky;
}

}  // namespace glint
