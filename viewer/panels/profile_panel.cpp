// The profile of a surface of revolution: its control points on a plot, to be dragged, and its curve.
#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <imgui.h>

#include "engine/builders/profile_builder.h"
#include "engine/math/bernstein.h"
#include "engine/scene/profile.h"
#include "viewer/model/profile_edits.h"
#include "viewer/model/scene_document.h"
#include "viewer/panels/panel.h"
#include "viewer/ui/theme.h"
#include "viewer/ui/widgets.h"

namespace glint {
namespace {

constexpr ui::KindLabel<CurveKind> kCurves[]{{CurveKind::Bezier, "Bézier"}, {CurveKind::Bspline, "B-spline"}};
constexpr float kPlotUnits = 260.0f;  ///< height
constexpr float kMarginUnits = 14.0f;
constexpr float kPointUnits = 5.0f;
constexpr ImU32 kPolygonColor = IM_COL32(255, 255, 255, 60);
constexpr ImU32 kAxisColor = IM_COL32(255, 255, 255, 45);
constexpr ImU32 kMirrorColor = IM_COL32(235, 235, 235, 90);
constexpr ImU32 kCurveColor = IM_COL32(235, 235, 235, 255);

std::vector<size_t> turnedObjects(const SceneDescription& scene) {
    std::vector<size_t> indices;
    for (size_t i = 0; i < scene.objects.size(); ++i) {
        if (scene.objects[i].shape == ShapeKind::Revolved) { indices.push_back(i); }
    }
    return indices;
}

/// Object space, the axis upright, to the screen, with one scale for both directions.
struct Plot {
    ImVec2 middle;
    Vec2 center;
    float unit = 1.0f;  ///< of the screen, for a metre

    ImVec2 place(Vec2 p) const {
        return {middle.x + (p.x - center.x) * unit, middle.y - (p.y - center.y) * unit};
    }
};

/// Room for both sides of the outline. Kept while a point is dragged, so that the plot holds still.
Plot plotOver(const std::vector<Vec2>& points, ImVec2 min, ImVec2 max) {
    static Vec2 half(1.0f);
    static Vec2 center(0.0f);
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        const Bounds box = profileBounds(points);
        center = Vec2(0.0f, 0.5f * (box.lo.y + box.hi.y));
        half = Vec2(std::max(box.hi.x, -box.lo.x), 0.5f * (box.hi.y - box.lo.y));
    }
    const float margin = kMarginUnits * ui::scale();
    const float least = std::max(1e-6f, 1e-3f * std::max(half.x, half.y));
    return {{0.5f * (min.x + max.x), 0.5f * (min.y + max.y)},
            center,
            std::min((0.5f * (max.x - min.x) - margin) / std::max(half.x, least),
                     (0.5f * (max.y - min.y) - margin) / std::max(half.y, least))};
}

void drawCurve(const Object& object, const Plot& plot, ImDrawList* draw) {
    constexpr int kSteps = 48;
    for (const ProfileCurve& curve : profileCurvesOf(object)) {
        std::vector<ImVec2> right, left;
        for (int i = 0; i <= kSteps; ++i) {
            const double s = static_cast<double>(i) / kSteps;
            const Vec2 p(evaluateBernstein<kMaxProfileDegree>(curve.x, curve.degree, s).value,
                         evaluateBernstein<kMaxProfileDegree>(curve.y, curve.degree, s).value);
            right.push_back(plot.place(p));
            left.push_back(plot.place({-p.x, p.y}));
        }
        const float width = 1.5f * ui::scale();
        draw->AddPolyline(left.data(), static_cast<int>(left.size()), kMirrorColor, ImDrawFlags_None, width);
        draw->AddPolyline(right.data(), static_cast<int>(right.size()), kCurveColor, ImDrawFlags_None, width);
    }
}

/// A point that takes the mouse. The widget's name is "Point 3".
void drawPoint(Object* object, size_t index, const Plot& plot, int* selected, ImDrawList* draw) {
    const Vec2 p = object->profile[index];
    const ImVec2 at = plot.place(p);
    const float radius = kPointUnits * ui::scale();
    const std::string name = fmt::format("Point {}", index + 1);
    ImGui::SetCursorScreenPos({at.x - radius, at.y - radius});
    ImGui::InvisibleButton(name.c_str(), {2.0f * radius, 2.0f * radius});
    ui::itemArea(name.c_str(), fmt::format("{:.6g} {:.6g}", p.x, p.y));
    if (ImGui::IsItemActivated()) { *selected = static_cast<int>(index); }
    if (ImGui::IsItemActive()) {
        const ImVec2 moved = ImGui::GetIO().MouseDelta;
        if (moved.x != 0.0f || moved.y != 0.0f) {
            moveProfilePoint(object, index, p + Vec2(moved.x, -moved.y) / plot.unit);
        }
    }
    const bool isHot = ImGui::IsItemHovered() || *selected == static_cast<int>(index);
    const ImU32 color = isHot ? ImGui::GetColorU32(theme::kAccent) : kCurveColor;
    draw->AddCircleFilled(at, isHot ? radius : 0.7f * radius, color);
}

void drawPlot(Object* object, int* selected) {
    const ImVec2 min = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const ImVec2 max{min.x + width, min.y + kPlotUnits * ui::scale()};
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->AddRectFilled(min, max, ImGui::GetColorU32(theme::kImageBackground));
    draw->PushClipRect(min, max, true);
    const Plot plot = plotOver(object->profile, min, max);
    const float axis = plot.place(Vec2(0.0f)).x;
    draw->AddLine({axis, min.y}, {axis, max.y}, kAxisColor);
    std::vector<ImVec2> polygon;
    for (const Vec2& point : object->profile) {
        polygon.push_back(plot.place(point));
    }
    draw->AddPolyline(polygon.data(), static_cast<int>(polygon.size()), kPolygonColor, ImDrawFlags_None,
                      ui::scale());
    drawCurve(*object, plot, draw);
    for (size_t i = 0; i < object->profile.size(); ++i) {
        drawPoint(object, i, plot, selected, draw);
    }
    draw->PopClipRect();
    ImGui::SetCursorScreenPos(min);
    ImGui::Dummy({width, max.y - min.y});
}

void drawSelected(Object* object, int* selected) {
    const auto index = static_cast<size_t>(*selected);
    const float size = maxComponent(absVec(profileBounds(object->profile).extent()));
    Vec2 at = object->profile[index];
    const ui::NumberStyle metres{.format = "%.4f m", .speed = std::max(1e-3f * size, 1e-6f)};
    const bool isMoved = static_cast<int>(ui::number("Distance", &at.x, metres)) +
                             static_cast<int>(ui::number("Height", &at.y, metres)) >
                         0;
    if (isMoved) { moveProfilePoint(object, index, at); }
    if (ui::button("Add points", ui::buttonWidth(2), "More points to shape the curve with")) {
        addProfilePoints(object, index);
    }
    ImGui::SameLine();
    if (ui::button("Remove", ui::buttonWidth(2), "The point that is chosen, or the curve that it is on")) {
        removeProfilePoints(object, index);
    }
}

void draw(SceneDocument* document) {
    std::vector<Object>& objects = document->draft().objects;
    const std::vector<size_t> turned = turnedObjects(document->draft());
    std::vector<std::string> names;
    names.reserve(std::size(turned));
    for (const size_t index : turned) {
        names.push_back(objects[index].name.empty() ? fmt::format("object {}", index) : objects[index].name);
    }
    const std::vector<std::string_view> views(names.begin(), names.end());
    int& selected = document->selectedProfile;
    selected = std::clamp(selected, 0, static_cast<int>(turned.size()) - 1);
    ui::choice("Surface", &selected, views, "Turned profiles of the scene");
    Object& object = objects[turned[static_cast<size_t>(selected)]];
    ImGui::PushID(selected);
    CurveKind curve = object.curve;
    if (ui::kindChoice("Curve", &curve, kCurves, "What the points make")) {
        Object changed = object;
        changed.curve = curve;
        changed.curveDegree = 0;
        if (profileFault(changed).empty()) { object = changed; }
    }
    int& point = document->selectedProfilePoint;
    point = std::clamp(point, 0, static_cast<int>(object.profile.size()) - 1);
    drawPlot(&object, &point);
    drawSelected(&object, &point);
    ui::toggle("Caps", &object.capped, "Discs where the profile ends off the axis");
    ui::toggle("Clamped search", &object.clampsSearch,
               "One search by Newton's method that is kept on the curve: it loses parts");
    ImGui::PopID();
}

bool isShown(const SceneDocument* document) { return !turnedObjects(document->draft()).empty(); }

}  // namespace

Panel profilePanel() {
    return {"Profile",
            false,
            OfParts<draw>::call,
            WithoutScene::Hides,
            "The curve that is turned, with its control points",
            OfParts<isShown>::call};
}

}  // namespace glint
