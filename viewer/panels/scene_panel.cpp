// Which scene is open, opening another, and what went wrong with that.
#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <imgui.h>

#include "engine/io/importer.h"
#include "viewer/model/key_map.h"
#include "viewer/model/scene_document.h"
#include "viewer/model/scene_files.h"
#include "viewer/panels/panel.h"
#include "viewer/ui/error_box.h"
#include "viewer/ui/theme.h"
#include "viewer/ui/widgets.h"

namespace glint {
namespace {

void drawRecent(SceneFiles* files) {
    const std::vector<std::string>& paths = files->recent.paths();
    if (paths.empty()) { return; }
    std::vector<std::string_view> names{"–"};
    names.insert(names.end(), paths.begin(), paths.end());
    int chosen = 0;
    if (ui::choice("Recent", &chosen, names, "Opened last, also in earlier sessions") && chosen > 0) {
        files->opened = paths[static_cast<size_t>(chosen) - 1];
        files->open(files->opened);
    }
}

/// A choice among `names` that goes to a parameter. `none` is shown where that is not given; null: the first.
bool chooseParameter(const char* parameter, SceneReading* reading, const char* label,
                     const std::vector<std::string>& names, const char* none, const char* tooltip) {
    std::vector<std::string_view> shown(names.begin(), names.end());
    const size_t before = none != nullptr ? 1 : 0;
    if (none != nullptr) { shown.insert(shown.begin(), none); }
    const std::string* given = findParameter(reading->options.parameters, parameter);
    const std::optional<size_t> found = given != nullptr ? indexIn(names, *given) : std::nullopt;
    int index = found ? static_cast<int>(*found + before) : 0;
    if (!ui::choice(label, &index, shown, tooltip)) { return false; }
    const auto chosen = static_cast<size_t>(index);
    setParameter(&reading->options.parameters, parameter, chosen < before ? "" : names[chosen - before]);
    return true;
}

bool chooseTime(SceneReading* reading, const SceneChoices::Animation& animation) {
    const float begin = animation.beginSeconds, end = animation.endSeconds;
    if (!(begin < end)) { return false; }
    const std::string* given = findParameter(reading->options.parameters, "time");
    auto seconds = static_cast<float>(given != nullptr ? numberIn(*given).value_or(0.0) : double{begin});
    if (!ui::number(
            "Time", &seconds,
            {.format = "%.3f s", .min = begin, .max = end, .slider = true, .tooltip = "Of the animation"})) {
        return false;
    }
    setParameter(&reading->options.parameters, "time", fmt::to_string(seconds));
    return true;
}

/// What a glTF file offers. It is read again for each choice, when a drag ends; the camera stays.
void drawChoices(SceneFiles* files, bool hasEdits) {
    SceneReading* reading = &files->reading;
    const SceneChoices& choices = reading->choices;
    if (!choices.variants.empty()) {
        reading->isStale |= chooseParameter("variant", reading, "Variant", choices.variants, "–",
                                            "Whose materials are shown; –: the file's own");
    }
    if (!choices.animations.empty()) {
        std::vector<std::string> names;
        for (const SceneChoices::Animation& animation : choices.animations) {
            names.push_back(animation.name);
        }
        reading->isStale |=
            chooseParameter("animation", reading, "Animation", names, nullptr, "Whose pose is shown");
        const std::string* given = findParameter(reading->options.parameters, "animation");
        const size_t shown = given != nullptr ? indexIn(names, *given).value_or(0) : 0;
        reading->isStale |= chooseTime(reading, choices.animations[shown]);
    }
    if (hasEdits && (!choices.variants.empty() || !choices.animations.empty())) {
        constexpr const char* kNote =
            "A choice reads the file again, without the unsaved edits; undo brings them back.";
        ui::hint(kNote);
        ui::itemArea("Choice note", kNote);
    }
    if (reading->isStale && !ImGui::IsAnyItemActive()) {
        reading->isStale = false;
        files->reload(reading->path);
    }
}

/// What was repaired or left out; all of it is in the log.
void drawWarnings(const std::vector<std::string>& warnings) {
    constexpr size_t kMostShown = 4;
    if (warnings.empty()) { return; }
    std::string text;
    for (size_t i = 0; i < std::min(warnings.size(), kMostShown); ++i) {
        text += (i > 0 ? "\n" : "") + warnings[i];
    }
    if (warnings.size() > kMostShown) { text += fmt::format("\n{} more: Log", warnings.size() - kMostShown); }
    ImGui::PushStyleColor(ImGuiCol_Text, theme::kTextError);
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::PopStyleColor();
    ui::itemArea("Warnings", text);
}

void draw(SceneFiles* files, const SceneDocument* document, const KeyMap* keys) {
    static const std::string kHelp = "A scene to open: " + listImporters() + ". Enter opens it.";
    const bool entered = ui::file("File", &files->opened, "scene.json, .txt, .obj, .ply", kHelp.c_str());
    const char* action = files->opening() ? "Opening…" : "Open";
    const float width = ui::buttonWidth(2);
    if ((ui::button(action, width) || entered) && !files->opening()) { files->open(files->opened); }
    ImGui::SameLine();
    const std::string tip = keys->tip("Look for a file in folders", KeyAction::OpenScene);
    if (ui::button("Browse…", width, tip.c_str())) { files->browse(); }
    drawRecent(files);
    if (files->error()) {
        ui::gap();
        const bool isDismissed = drawErrorBox("This scene cannot be opened", *files->error());
        if (document->isOpen()) { ui::hint("The scene that was open goes on."); }
        const bool isWanted = files->opensWithoutFiles() && ui::button("Open anyway", ui::buttonWidth(1),
                                                                       "Without the files that are missing");
        if (isDismissed) {
            files->dismissError();
        } else if (isWanted) {
            files->openWithoutFiles();
        }
    }
    if (!document->isOpen()) { return; }
    if (files->reading.path == document->draft().path) { drawChoices(files, document->hasUnsavedEdits()); }
    drawWarnings(document->draft().warnings);
    for (const std::string* text : {&document->draft().title, &document->draft().description}) {
        if (!text->empty()) { ui::hint(text->c_str()); }
    }
}

}  // namespace

Panel scenePanel() { return {"Scene", true, OfParts<draw>::call}; }

}  // namespace glint
