#include "viewer/window/gizmo_view.h"

#include <utility>

#include <imgui.h>

#include "engine/scene/object_box.h"
#include "viewer/ui/widgets.h"
#include "viewer/window/split_view.h"

namespace glint {
namespace {

constexpr float kLengthUnits = 84.0f;
constexpr float kReachUnits = 7.0f;
constexpr const char* kNames[] = {"Gizmo X", "Gizmo Y", "Gizmo Z"};
constexpr ImU32 kColors[] = {IM_COL32(235, 90, 80, 255), IM_COL32(120, 200, 70, 255),
                             IM_COL32(90, 140, 250, 255)};
constexpr ImU32 kMeant = IM_COL32(255, 225, 110, 255);

ImVec2 im(Vec2 v) { return {v.x, v.y}; }

bool isSame(const GizmoHandle& a, const GizmoHandle& b) { return a.kind == b.kind && a.axis == b.axis; }

/// On a dark edge, to be seen on any picture.
void drawLine(const std::vector<Vec2>& line, ImU32 color) {
    ImDrawList* draw = ImGui::GetWindowDrawList();
    for (const bool isEdge : {true, false}) {
        for (size_t i = 1; i < line.size(); ++i) {
            draw->AddLine(im(line[i - 1]), im(line[i]), isEdge ? IM_COL32(0, 0, 0, 120) : color,
                          (isEdge ? 5.0f : 2.5f) * ui::scale());
        }
    }
}

}  // namespace

/// In the object's own space: meshes may lie far from their origin.
Vec3 GizmoView::pivotOf(const SceneDescription& scene, const Object& object) {
    const auto index = static_cast<size_t>(object.mesh);
    const bool hasMesh = object.mesh >= 0 && index < scene.meshes.size() && scene.meshes[index].data;
    if (!hasMesh) { return Vec3(0.0f); }
    if (pivotMesh_ != scene.meshes[index].data) {
        pivotMesh_ = scene.meshes[index].data;
        meshPivot_ = Vec3(meshBox(*pivotMesh_).center());
    }
    return meshPivot_;
}

bool GizmoView::handle(Workspace* workspace, const PlacedImage& placed, bool hovered, bool held) {
    const ImGuiIO& io = ImGui::GetIO();
    SceneDescription& scene = workspace->document.draft();
    const GizmoSettings& settings = workspace->gizmo;
    const auto index = static_cast<size_t>(workspace->document.selectedObject);
    const bool isPressed = held && !std::exchange(wasHeld_, held);
    wasHeld_ = held;
    handles_.clear();
    meant_.reset();
    const bool hasObject = workspace->document.selectedObject >= 0 && index < scene.objects.size();
    if (settings.mode == GizmoMode::Off || !hasObject || isSideBySide(*workspace)) {
        gizmo_.end();
        return false;
    }
    Object& object = scene.objects[index];
    const Vec3 pivot = pivotOf(scene, object);
    const Vec2i picture(scene.resolution.width, scene.resolution.height);
    const ScreenView view(scene.camera, picture, placed);
    const Vec2 mouse(io.MousePos.x, io.MousePos.y);
    if (!held) { gizmo_.end(); }
    if (gizmo_.isDragging()) {
        const bool snaps = settings.snaps != io.KeyCtrl;
        object.objectToWorld = gizmo_.drag(settings, view, mouse, snaps) * translate(-pivot);
    }
    const Affine pivoted = object.objectToWorld * translate(pivot);
    handles_ = gizmo_.handles(pivoted, settings, view, kLengthUnits * ui::scale());
    meant_ = gizmo_.isDragging() ? std::optional(gizmo_.held())
             : hovered           ? Gizmo::nearest(handles_, mouse, kReachUnits * ui::scale())
                                 : std::nullopt;
    if (isPressed && meant_ && ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        gizmo_.begin(*meant_, pivoted, settings, view, mouse);
    }
    return gizmo_.isDragging() || (meant_ && !held);
}

void GizmoView::draw() const {
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const float half = 5.0f * ui::scale();
    for (const GizmoHandle& handle : handles_) {
        const bool isMeant = meant_ && isSame(*meant_, handle);
        const Vec2 end = handle.line.back();
        if (handle.kind == GizmoHandle::Kind::Middle) {
            const ImU32 color = isMeant ? kMeant : IM_COL32(235, 235, 235, 255);
            draw->AddRectFilled(im(end - half), im(end + half), IM_COL32(0, 0, 0, 120));
            draw->AddRect(im(end - half), im(end + half), color, 0.0f, 0, 1.5f * ui::scale());
            ui::area("Gizmo middle", end - half, end + half, "");
            continue;
        }
        const ImU32 color = isMeant ? kMeant : kColors[handle.axis];
        drawLine(handle.line, color);
        if (handle.kind == GizmoHandle::Kind::Axis) { draw->AddCircleFilled(im(end), half, color); }
        ui::area(kNames[handle.axis], end - half, end + half, "");
    }
}

}  // namespace glint
