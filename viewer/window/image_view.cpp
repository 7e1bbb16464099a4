#include "viewer/window/image_view.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include <imgui.h>

#include "viewer/model/camera_controller.h"
#include "viewer/ui/eyedropper.h"
#include "viewer/ui/theme.h"
#include "viewer/ui/widgets.h"
#include "viewer/window/gallery_view.h"
#include "viewer/window/image_notes.h"
#include "viewer/window/key_input.h"
#include "viewer/window/split_view.h"

namespace glint {
namespace {

constexpr float kFlySpeed = 0.7f;  // target distances per second
constexpr float kFastFactor = 4.0f;
constexpr double kWheelHoldSeconds = 0.15;
constexpr float kDividerStep = 0.02f;  // of the width of what is seen of the image
constexpr float kFineShare = 0.1f;

/// Which way the fly keys point; zero when none is down or a text field has the keyboard.
Vec3 flyDirection(const KeyMap& keys) {
    const auto axis = [&keys](KeyAction plus, KeyAction minus) {
        return static_cast<float>(isHeld(keys, plus)) - static_cast<float>(isHeld(keys, minus));
    };
    return {axis(KeyAction::FlyRight, KeyAction::FlyLeft), axis(KeyAction::FlyUp, KeyAction::FlyDown),
            axis(KeyAction::FlyForwards, KeyAction::FlyBack)};
}

/// Where the picture may be, or the left one of two side by side.
ImageArea areaOf(const Workspace& workspace, Vec2 min, Vec2 max) {
    if (isSideBySide(workspace)) { max.x = std::floor((min.x + max.x) * 0.5f); }
    const Resolution& size = workspace.document.draft().resolution;
    return {min, max, Vec2i(std::max(size.width, 1), std::max(size.height, 1)),
            std::max(ImGui::GetIO().DisplayFramebufferScale.x, 1.0f)};
}

/// From the right one of two pictures side by side to the same place of the left one.
Vec2 foldedBack(Vec2 at, const ImageArea& left) {
    const float width = left.max.x - left.min.x;
    const bool isHalf = ImGui::GetWindowSize().x > 1.5f * width;
    return isHalf && at.x >= left.max.x ? Vec2(at.x - width, at.y) : at;
}

Vec2 mousePosition() { return {ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y}; }

/// By keys.
void moveDivider(const KeyMap& keys, DisplaySettings* settings) {
    const float step = kDividerStep * (ImGui::GetIO().KeyShift ? kFineShare : 1.0f);
    if (isPressed(keys, KeyAction::DividerLeft, true)) { settings->splitAt -= step; }
    if (isPressed(keys, KeyAction::DividerRight, true)) { settings->splitAt += step; }
    settings->splitAt = std::clamp(settings->splitAt, 0.0f, 1.0f);
}

void drawHint(Vec2 min, Vec2 max, const char* text) {
    const ImVec2 size = ImGui::CalcTextSize(text);
    const ImVec2 corner{(min.x + max.x - size.x) * 0.5f, (min.y + max.y - size.y) * 0.5f};
    ImGui::GetWindowDrawList()->AddText(corner, ImGui::GetColorU32(theme::kTextDim), text);
}

/// Of a scene that cannot be opened; the panel says more.
void drawErrorNote(const Error& error, Vec2 min, Vec2 max) {
    const float margin = noteMargin();
    const std::string whole = error.format();
    const std::string text = whole.substr(0, whole.find('\n'));
    const float room = max.x - min.x - 2.0f * margin;
    const float wanted = plateSize(text, 0.0f).x;
    const Vec2 size = plateSize(text, wanted > room ? room : 0.0f);
    const Vec2 corner(min.x + margin, max.y - margin - size.y);
    drawPlate(text, corner, size);
    ui::area("Error note", corner, corner + size, text);
}

void beginImageWindow(Vec2 min, Vec2 max, bool hasScene) {
    ImGui::SetNextWindowPos({min.x, min.y});
    ImGui::SetNextWindowSize({max.x - min.x, max.y - min.y});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
    ImGui::PushStyleColor(ImGuiCol_WindowBg, theme::kImageBackground);
    ImGui::Begin("##image", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollWithMouse |
                     (hasScene ? ImGuiWindowFlags_NoNav : 0));
}

}  // namespace

/// The mouse's way since the last frame, once a press has become a drag by some pixels. What it went before
/// the press does not count, even if both came in one frame.
Vec2 ImageView::dragged(bool held) {
    const bool wasDragging = std::exchange(isDragging_, held && isDragging_);
    if (!held) { return Vec2(0.0f); }
    if (wasDragging) { return {ImGui::GetIO().MouseDelta.x, ImGui::GetIO().MouseDelta.y}; }
    for (const int button : {ImGuiMouseButton_Left, ImGuiMouseButton_Right, ImGuiMouseButton_Middle}) {
        if (!ImGui::IsMouseDragging(button)) { continue; }
        isDragging_ = true;
        const ImVec2 way = ImGui::GetMouseDragDelta(button);
        return {way.x, way.y};
    }
    return Vec2(0.0f);
}

/// Around the mouse where it is over the area, otherwise around the middle.
void ImageView::handleZoomKeys(const KeyMap& keys, const ImageArea& area, ImageFraming* framing) const {
    const Vec2 mouse = foldedBack(mousePosition(), area);
    const bool isInside =
        glm::all(glm::greaterThanEqual(mouse, area.min)) && glm::all(glm::lessThan(mouse, area.max));
    const Vec2 at = isInside ? mouse : (area.min + area.max) * 0.5f;
    if (isPressed(keys, KeyAction::ZoomIn, true)) { framing->zoomBy(1, at, area); }
    if (isPressed(keys, KeyAction::ZoomOut, true)) { framing->zoomBy(-1, at, area); }
    if (isPressed(keys, KeyAction::OneToOne)) { framing->chooseOneToOne(); }
    if (isPressed(keys, KeyAction::FitImage)) { *framing = {}; }
}

bool ImageView::navigate(Workspace* workspace, const ImageArea& area, bool hovered, bool held) {
    Camera* camera = &workspace->document.draft().camera;
    ImageFraming* framing = &workspace->display.framing;
    const ImGuiIO& io = ImGui::GetIO();
    const float height = placed_.max.y - placed_.min.y;
    const Vec2 delta = dragged(held);
    if (!isZero(Vec3(delta, 0.0f))) {
        const bool isLeft = ImGui::IsMouseDown(ImGuiMouseButton_Left);
        if (!isLeft && io.KeyCtrl) {
            framing->panBy(delta, area);
        } else if (!isLeft || io.KeyShift) {
            pan(camera, delta, height);
        } else if (io.KeyCtrl) {
            lookAround(camera, delta, height);
        } else {
            orbit(camera, delta, height);
        }
    }
    if (hovered && io.KeyCtrl) {
        wheelSteps_ += io.MouseWheel;
        const float whole = std::trunc(wheelSteps_);
        wheelSteps_ -= whole;
        framing->zoomBy(static_cast<int>(whole), foldedBack(mousePosition(), area), area);
    } else if (hovered && io.MouseWheel != 0.0f) {
        dolly(camera, io.MouseWheel);
        lastWheel_ = ImGui::GetTime();
    }
    const Vec3 direction = flyDirection(workspace->keys);
    const bool flying = !isZero(direction);
    if (flying) {
        const float speed = kFlySpeed * (io.KeyShift ? kFastFactor : 1.0f);
        fly(camera, direction * (speed * std::min(io.DeltaTime, 0.1f)));
    }
    return isDragging_ || flying || (lastWheel_ >= 0.0 && ImGui::GetTime() - lastWheel_ < kWheelHoldSeconds);
}

/// Which pixel the mouse is on, and on whose side.
void ImageView::findPixel(const Workspace& workspace, const ImageArea& area) {
    const Vec2 mouse = foldedBack(mousePosition(), area);
    const bool onRight = seesRight(workspace, placed_, mousePosition().x);
    const bool isInside =
        glm::all(glm::greaterThanEqual(mouse, placed_.min)) && glm::all(glm::lessThan(mouse, placed_.max));
    if (!isInside) { return; }
    hoveredPixel_ = pixelAt(placed_, mouse);
    hoversOther_ = workspace.isComparing() && !isDifference(workspace.display.compareView) &&
                   onRight != workspace.ownIsRight();
}

/// A click gives the colour that is under the mouse to the field that waits for one.
void ImageView::giveColor(const Workspace& workspace, bool isClick) const {
    const auto& snapshot = hoversOther_ ? workspace.otherImage() : workspace.ownImage();
    if (!hoveredPixel_ || !snapshot || snapshot->radiance.empty()) { return; }
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (isClick) { ui::giveColor(colorAt(*snapshot, *hoveredPixel_)); }
}

/// Focuses by Ctrl + click, by a click once the panel asked for one, or by T; any other click selects.
void ImageView::pick(Workspace* workspace, bool isClick) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool picks = workspace->lens.picksFocus;
    if (picks && hoveredPixel_) { ImGui::SetMouseCursor(ImGuiMouseCursor_Hand); }
    const bool isWanted = isPressed(workspace->keys, KeyAction::Focus) || (isClick && (picks || io.KeyCtrl));
    if (!hoveredPixel_) { return; }
    workspace->inspector.pixel = hoveredPixel_;
    if (isWanted) {
        workspace->focusAt(*hoveredPixel_);
    } else if (isClick) {
        workspace->selectAt(*hoveredPixel_);
    }
}

/// A material that is dropped on the item that was drawn last goes to the object there.
void ImageView::takeMaterial(Workspace* workspace, const ImageArea& area) {
    if (!ImGui::BeginDragDropTarget()) { return; }
    const ImGuiPayload* payload =
        ImGui::AcceptDragDropPayload(MaterialDrag::kKind, ImGuiDragDropFlags_AcceptNoDrawDefaultRect);
    findPixel(*workspace, area);
    if (payload != nullptr && hoveredPixel_) {
        MaterialDrag given;
        std::memcpy(&given, payload->Data, sizeof given);
        workspace->giveMaterialAt(*hoveredPixel_, given);
    }
    ImGui::EndDragDropTarget();
}

void ImageView::drawOverlay(const FocusOverlay& overlay, const ImageDisplay& display) const {
    if (overlay.colors().empty() || display.texture() == 0) { return; }
    ImGui::GetWindowDrawList()->AddImage(
        reinterpret_cast<ImTextureID>(static_cast<intptr_t>(display.texture())),
        {placed_.min.x, placed_.min.y}, {placed_.max.x, placed_.max.y});
}

bool ImageView::draw(Workspace* workspace, const ImagePanes& panes, Vec2 min, Vec2 max) {
    const bool hasScene = workspace->document.isOpen();
    beginImageWindow(min, max, hasScene);
    const ImageArea area = areaOf(*workspace, min, max);
    ImageFraming& framing = workspace->display.framing;
    if (hasScene) {
        handleZoomKeys(workspace->keys, area, &framing);
        placed_ = framing.place(area);
        if (hasDivider(*workspace)) {
            moveDivider(workspace->keys, &workspace->display);
            dragDivider(&workspace->display, placed_);
        }
    }
    ImGui::SetCursorScreenPos({min.x, min.y});
    // A click on the image takes the keyboard back from a text field.
    const bool isReleased = hasScene && ImGui::InvisibleButton("##area", {max.x - min.x, max.y - min.y},
                                                               ImGuiButtonFlags_MouseButtonLeft |
                                                                   ImGuiButtonFlags_MouseButtonRight |
                                                                   ImGuiButtonFlags_MouseButtonMiddle);
    const bool isClick =
        isReleased && !isDragging_ && !drew_ && ImGui::IsMouseReleased(ImGuiMouseButton_Left);
    const bool hovered = ImGui::IsItemHovered();
    const bool held = ImGui::IsItemActive();
    hoveredPixel_.reset();
    if (hasScene) { takeMaterial(workspace, area); }
    bool moving = false;
    if (hasScene) {
        if (hovered || held) { findPixel(*workspace, area); }
        const bool draws = region_.handle(workspace, placed_, hoveredPixel_, held) ||
                           gizmo_.handle(workspace, placed_, hovered, held);
        drew_ = held && (drew_ || draws);
        moving = navigate(workspace, area, hovered, held && !draws) || gizmo_.isNudging();
        placed_ = framing.place(area);
        if (panes.own.display->texture() != 0) {
            drawPanes(*workspace, panes, placed_);
            drawOverlay(workspace->focusOverlay, *panes.overlay);
        } else {
            drawHint(min, max, "Building…");
        }
        region_.draw(*workspace, placed_);
        gizmo_.draw();
        if (hovered) { findPixel(*workspace, area); }
        if (ui::waitsForColor()) {
            giveColor(*workspace, isClick);
        } else if (!draws) {
            pick(workspace, isClick);
        }
    } else {
        workspace->sceneFiles.opening() ? drawHint(min, max, "Opening…") : drawGallery(workspace, min, max);
    }
    if (workspace->sceneFiles.error()) { drawErrorNote(*workspace->sceneFiles.error(), min, max); }
    ui::area("Image", min, max, "");
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    return moving;
}

}  // namespace glint
