#include "viewer/panels/gizmo_rows.h"

#include "viewer/ui/widgets.h"

namespace glint {

void drawGizmoRows(GizmoSettings* gizmo, const KeyMap& keys) {
    static constexpr ui::KindLabel<GizmoMode> kModes[]{{GizmoMode::Off, "Off"},
                                                       {GizmoMode::Move, "Move"},
                                                       {GizmoMode::Rotate, "Rotate"},
                                                       {GizmoMode::Scale, "Scale"}};
    ui::kindChoice("Gizmo", &gizmo->mode, kModes,
                   (keys.tip("Handles over the picture, to drag; the next kind", KeyAction::Gizmo) +
                    ". Arrows, PageUp and PageDown move it, too: see the list of keys")
                       .c_str());
    if (gizmo->mode == GizmoMode::Off) { return; }
    ui::toggle("Own axes", &gizmo->isLocal, "The object's instead of the world's; scaling always has these");
    ui::toggle("Snap", &gizmo->snaps, "In steps; Ctrl while dragging does the opposite");
    switch (gizmo->mode) {
        case GizmoMode::Move:
            ui::number("Step", &gizmo->moveStep, {.format = "%.3f m", .speed = 0.005f, .max = 1e6f});
            break;
        case GizmoMode::Rotate:
            ui::number("Step", &gizmo->turnStepDeg, {.format = "%.1f°", .speed = 0.5f, .max = 180.0f});
            break;
        case GizmoMode::Scale:
            ui::number("Step", &gizmo->scaleStep, {.format = "× %.2f", .speed = 0.005f, .max = 10.0f});
            break;
        case GizmoMode::Off:
            break;
    }
}

}  // namespace glint
