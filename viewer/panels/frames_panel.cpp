// Numbered pictures of a camera that moves: a turn around what is looked at, or a flight through
// the bookmarks.
#include <cfloat>
#include <string>

#include <imgui.h>

#include "viewer/model/frame_series.h"
#include "viewer/panels/panel.h"
#include "viewer/ui/theme.h"
#include "viewer/ui/widgets.h"

namespace glint {
namespace {

void drawWishes(FrameSeries* frames) {
    static constexpr ui::KindLabel<bool> kWays[]{{false, "Round the target"},
                                                 {true, "Through the bookmarks"}};
    ui::kindChoice("Way", &frames->isFlight, kWays, "A whole turn of the camera, or from view to view");
    ui::integer(
        "Pictures", &frames->images,
        {.format = "%d", .speed = 0.2f, .min = 2.0f, .max = 100000.0f, .tooltip = "On the whole way"});
    ui::integer("Passes each", &frames->passes,
                {.format = "%d passes",
                 .speed = 1.0f,
                 .max = 1e7f,
                 .zeroText = "none",
                 .tooltip = "What ends a picture, with the seconds: the first that is reached. 0: no limit"});
    ui::number("Seconds each", &frames->seconds,
               {.format = "%.0f s",
                .speed = 0.5f,
                .max = 1e7f,
                .zeroText = "none",
                .tooltip = "What ends a picture, with the passes: the first that is reached. 0: no limit",
                .unit = "s"});
    ui::file("Folder", &frames->folder, "turntable",
             "For frame-000001.png and so on, as the picture is shown");
}

void drawProgress(FrameSeries* frames) {
    ui::value("Picture", frames->progressText());
    ImGui::ProgressBar(frames->progress(), {-FLT_MIN, ImGui::GetFontSize() * 0.45f}, "");
    if (ui::button("Cancel", ui::buttonWidth(1), "Whole pictures stay")) { frames->cancel(); }
    ui::hint("The live picture waits, and goes on where it was.");
}

void draw(FrameSeries* frames, const DisplaySettings* display) {
    if (frames->isRunning()) { return drawProgress(frames); }
    drawWishes(frames);
    if (const std::string missing = frames->missing(); !missing.empty()) { return ui::hint(missing.c_str()); }
    if (const std::string& obstacles = frames->obstacles(); !obstacles.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, theme::kTextError);
        ImGui::TextWrapped("In the way: %s.", obstacles.c_str());
        ImGui::PopStyleColor();
        ui::itemArea("Obstacles", obstacles);
    }
    if (ui::button("Render the pictures", ui::buttonWidth(1), "Of the scene as it is now, beside the window",
                   true)) {
        frames->start(*display);
    }
}

}  // namespace

Panel framesPanel() {
    return {"Turntable", false, OfParts<draw>::call, WithoutScene::Hides,
            "Numbered pictures of a camera that moves"};
}

}  // namespace glint
