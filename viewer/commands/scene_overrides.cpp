#include "viewer/commands/scene_overrides.h"

#include <cctype>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "engine/base/nearest_name.h"
#include "engine/builders/scene_validation.h"
#include "engine/scene/as_original.h"
#include "viewer/commands/command_line.h"
#include "viewer/commands/render_options.h"

namespace glint {
namespace {

constexpr const char* kSettingsGroup = "Instead of the scene's own settings";

/// Of the settings of one integrator.
std::string groupOf(const TextSetting& setting) {
    return setting.only ? fmt::format("{}, instead of the scene's own settings",
                                      integratorInfo(*setting.only).displayName)
                        : kSettingsGroup;
}

std::string capitalised(std::string text) {
    text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text;
}

void addOption(const Command& command, SceneOverrides::Given* given) {
    const TextSetting& setting = *given->setting;
    const std::string name(setting.option), group = groupOf(setting);
    const std::string help = capitalised(setting.help);
    if (setting.isVector) {
        command.option(name, &given->numbers, help).typeName("X,Y,Z").commaSeparated(3, 3).group(group);
        return;
    }
    const std::string words = setting.isNumber ? "" : fmt::format(" ({})", setting.expected);
    command.option(name, &given->text, help + words).typeName("VALUE").group(group);
}

Status applySize(const std::string& text, SceneDescription* scene) {
    const Result<Vec2i> size = parsePair(text, 'x', "--size");
    if (!size) { return size.error(); }
    if (size->x < 1 || size->y < 1 || size->x > kMaxResolution || size->y > kMaxResolution) {
        return Error{fmt::format("--size is {}; expected 1 to {} pixels each way", text, kMaxResolution), {}};
    }
    scene->resolution = {size->x, size->y};
    return {};
}

/// "--photons, --alpha": the options of one integrator.
std::string optionsOf(IntegratorKind integrator) {
    std::vector<std::string_view> names;
    for (const TextSetting& setting : textSettings()) {
        if (setting.only == integrator && !setting.option.empty()) { names.push_back(setting.option); }
    }
    return fmt::format("{}", fmt::join(names, ", "));
}

Status applySetting(const SceneOverrides::Given& given, SceneDescription* scene) {
    const TextSetting& setting = *given.setting;
    const std::string text = setting.isVector ? fmt::format("{}", fmt::join(given.numbers, ",")) : given.text;
    if (setting.only && scene->options.integrator != *setting.only) {
        const IntegratorInfo& owner = integratorInfo(*setting.only);
        return Error{fmt::format("{} are settings of {}; add --integrator {}", optionsOf(owner.kind),
                                 owner.displayName, owner.key),
                     {}};
    }
    if (!setting.set(text, {&scene->camera, &scene->options, &scene->sppm, &scene->rayCast})) {
        return Error{fmt::format("{} is '{}'{}; expected {}", setting.option, text,
                                 didYouMean(text, setting.words), setting.expected),
                     {}};
    }
    if (setting.option == "--filter") { scene->options.filterRadius = usualRadius(scene->options.filter); }
    return {};
}

}  // namespace

void addSceneOverrides(const Command& command, SceneOverrides* overrides,
                       const std::function<bool(std::string_view option)>& wanted) {
    command.option("--size", &overrides->size, "Picture size in pixels")
        .typeName("WxH")
        .group(kSettingsGroup);
    command
        .flag(
            "--as-original", &overrides->asOriginal,
            "As the program that 6.837 texts were written for: depth 20, a box filter of 1 pixel each way, a "
            "square lens; render: --tone clamp, exposure 0")
        .group(kSettingsGroup);
    for (const TextSetting& setting : textSettings()) {
        const bool has = !setting.option.empty() && (!wanted || wanted(setting.option));
        if (has) { overrides->settings.push_back({.setting = &setting}); }
    }
    for (SceneOverrides::Given& given : overrides->settings) {
        addOption(command, &given);
    }
}

std::string sceneOptionsAsWritten(const Command& command) {
    std::string all;
    for (const GivenOption& option : command.given()) {
        if (option.group == kSettingsGroup) {
            all += " " + option.name + (option.takesValue ? " " + quotedForShell(option.value) : "");
        }
    }
    return all;
}

Status applyTo(const SceneOverrides& overrides, SceneDescription* scene) {
    if (overrides.asOriginal) { setAsOriginal(scene); }
    if (!overrides.size.empty()) {
        if (Status sized = applySize(overrides.size, scene); !sized) { return sized; }
    }
    for (const SceneOverrides::Given& given : overrides.settings) {
        if (given.text.empty() && given.numbers.empty()) { continue; }
        if (Status applied = applySetting(given, scene); !applied) { return applied; }
    }
    return {};
}

}  // namespace glint
