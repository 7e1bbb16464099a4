#include "viewer/window/gizmo_view.h"

#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <imgui.h>

#include "engine/scene/object_box.h"
#include "viewer/model/light_placement.h"
#include "viewer/ui/im_vec.h"
#include "viewer/ui/widgets.h"
#include "viewer/window/key_input.h"
#include "viewer/window/split_view.h"

namespace glint {
namespace {

constexpr float kLengthUnits = 84.0f;
constexpr float kReachUnits = 7.0f;
constexpr const char* kNames[] = {"Gizmo X", "Gizmo Y", "Gizmo Z"};
constexpr ImU32 kColors[] = {IM_COL32(235, 90, 80, 255), IM_COL32(120, 200, 70, 255),
                             IM_COL32(90, 140, 250, 255)};
constexpr size_t kMostMarks = 500;
constexpr ImU32 kBeam = IM_COL32(255, 235, 150, 255);
constexpr ImU32 kMeant = IM_COL32(255, 225, 110, 255);

struct NudgeKey {
    KeyAction action;
    std::optional<int> axis;
    float direction;
};
constexpr NudgeKey kNudgeKeys[] = {
    {KeyAction::GizmoXLess, 0, -1.0f}, {KeyAction::GizmoXMore, 0, 1.0f},  {KeyAction::GizmoYLess, 1, -1.0f},
    {KeyAction::GizmoYMore, 1, 1.0f},  {KeyAction::GizmoZLess, 2, -1.0f}, {KeyAction::GizmoZMore, 2, 1.0f},
    {KeyAction::GizmoLess, {}, -1.0f}, {KeyAction::GizmoMore, {}, 1.0f},
};

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

/// The selected object, or else the selected light; nothing where neither is there.
std::optional<GizmoView::Target> GizmoView::targetOf(Workspace* workspace) {
    SceneDocument& document = workspace->document;
    SceneDescription& scene = document.draft();
    const auto object = static_cast<size_t>(document.selectedObject);
    const auto light = static_cast<size_t>(document.selectedLight);
    if (document.selectedObject >= 0 && object < scene.objects.size()) {
        Object* placed = &scene.objects[object];
        const Vec3 pivot = pivotOf(scene, *placed);
        return Target{workspace->gizmo,
                      placed->objectToWorld * translate(pivot),
                      {},
                      [placed, pivot](const Affine& to) { placed->objectToWorld = to * translate(-pivot); }};
    }
    if (document.selectedLight < 0 || light >= scene.lights.size()) { return std::nullopt; }
    Light* placed = &scene.lights[light];
    const Affine place = placeOf(*placed, scene.camera.target);
    const bool hasBeam = placed->kind != LightKind::Point;
    return Target{settingsFor(*placed, workspace->gizmo), place,
                  hasBeam ? std::optional(place.linear[2]) : std::nullopt,
                  [placed](const Affine& to) { placeLight(placed, to); }};
}

bool GizmoView::nudge(const KeyMap& keys, const ScreenView& view, const Target& target) {
    bool isMoved = false;
    Affine place = target.placed;
    const float metres = view.metresPer(kLengthUnits * ui::scale(), place.translation);
    static_assert(std::size(kNudgeKeys) == std::tuple_size_v<decltype(isMeant_)>);
    for (size_t i = 0; i < std::size(kNudgeKeys); ++i) {
        const NudgeKey& each = kNudgeKeys[i];
        // An arrow that was pressed with Alt moves no object when Alt is let go first.
        isMeant_[i] = isPressed(keys, each.action) || (isMeant_[i] && isHeld(keys, each.action));
        isNudging_ = isNudging_ || isMeant_[i];
        if (!isMeant_[i] || !isPressed(keys, each.action, true)) { continue; }
        place = Gizmo::nudged(place, target.settings, {each.axis, each.direction, ImGui::GetIO().KeyShift},
                              metres);
        isMoved = true;
    }
    if (isMoved) { target.place(place); }
    return isMoved;
}

/// Where lights stand that can be chosen by a click. True: the mouse is on one.
bool GizmoView::handleMarks(Workspace* workspace, const ScreenView& view, Vec2 mouse, bool isPressed) {
    const std::vector<Light>& lights = workspace->document.draft().lights;
    for (size_t i = 0; i < lights.size() && i < kMostMarks; ++i) {
        if (lights[i].kind == LightKind::Directional) { continue; }
        if (const auto at = view.project(lights[i].position)) {
            marks_.push_back({*at, static_cast<int>(i)});
        }
    }
    for (const Mark& mark : marks_) {
        if (glm::length(mark.at - mouse) > kReachUnits * ui::scale()) { continue; }
        if (isPressed) {
            workspace->document.selectedLight = mark.light;
            workspace->document.selectedObject = -1;
        }
        return true;
    }
    return false;
}

bool GizmoView::handle(Workspace* workspace, const PlacedImage& placed, bool hovered, bool held) {
    const ImGuiIO& io = ImGui::GetIO();
    const SceneDescription& scene = workspace->document.draft();
    const bool isPressed =
        held && !std::exchange(wasHeld_, held) && ImGui::IsMouseDown(ImGuiMouseButton_Left);
    wasHeld_ = held;
    handles_.clear();
    marks_.clear();
    beam_.clear();
    meant_.reset();
    isNudging_ = false;
    if (workspace->gizmo.mode == GizmoMode::Off || isSideBySide(*workspace)) {
        gizmo_.end();
        return false;
    }
    auto target = targetOf(workspace);
    const Vec2i image(scene.resolution.width, scene.resolution.height);
    const ScreenView view(scene.camera, image, placed);
    const Vec2 mouse(io.MousePos.x, io.MousePos.y);
    if (!held || !target) { gizmo_.end(); }
    if (gizmo_.isDragging()) {
        target->place(gizmo_.drag(target->settings, view, mouse, target->settings.snaps != io.KeyCtrl));
        target = targetOf(workspace);
    }
    if (target && !gizmo_.isDragging() && nudge(workspace->keys, view, *target)) {
        target = targetOf(workspace);
    }
    if (target) {
        const float length = kLengthUnits * ui::scale();
        handles_ = gizmo_.handles(target->placed, target->settings, view, length);
        const Vec3 origin = target->placed.translation;
        const auto from = view.project(origin);
        const auto to = target->beam && from
                            ? view.project(origin + *target->beam * view.metresPer(length, origin))
                            : std::nullopt;
        if (to) { beam_ = {*from, *to}; }
    }
    meant_ = gizmo_.isDragging() ? std::optional(gizmo_.held())
             : hovered           ? Gizmo::nearest(handles_, mouse, kReachUnits * ui::scale())
                                 : std::nullopt;
    if (isPressed && meant_) { gizmo_.begin(*meant_, target->placed, target->settings, view, mouse); }
    const bool isOnMark = handleMarks(workspace, view, mouse, isPressed && !meant_);
    return gizmo_.isDragging() || ((meant_ || (isOnMark && hovered)) && !held) || (isOnMark && isPressed);
}

void GizmoView::draw() const {
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const float half = 5.0f * ui::scale();
    for (const Mark& mark : marks_) {
        draw->AddCircleFilled(im(mark.at), half, IM_COL32(0, 0, 0, 120));
        draw->AddCircle(im(mark.at), half, kBeam, 0, 1.5f * ui::scale());
        ui::area(fmt::format("Light mark {}", mark.light + 1).c_str(), mark.at - half, mark.at + half, "");
    }
    if (!beam_.empty()) { drawLine(beam_, kBeam); }
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
