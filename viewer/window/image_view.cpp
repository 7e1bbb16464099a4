#include "viewer/window/image_view.h"

#define GLFW_INCLUDE_NONE
#include <algorithm>
#include <cmath>
#include <utility>

#include <GLFW/glfw3.h>
#include <imgui.h>

#include "viewer/model/camera_controller.h"
#include "viewer/ui/theme.h"
#include "viewer/ui/widgets.h"
#include "viewer/window/split_view.h"

namespace glint {
namespace {

constexpr float kFlySpeed = 0.7f;  // target distances per second
constexpr float kFastFactor = 4.0f;
constexpr double kWheelHoldSeconds = 0.15;

bool isDown(int key) { return ImGui::IsKeyDown(key); }

/// Which way the fly keys point; zero when none is down or a text field has the keyboard.
Vec3 flyDirection() {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantTextInput || io.KeyCtrl || io.KeyAlt) { return Vec3(0.0f); }
    const auto axis = [](int plus, int minus) {
        return static_cast<float>(isDown(plus)) - static_cast<float>(isDown(minus));
    };
    return {axis(GLFW_KEY_D, GLFW_KEY_A), axis(GLFW_KEY_E, GLFW_KEY_Q), axis(GLFW_KEY_W, GLFW_KEY_S)};
}

void drawHint(Vec2 min, Vec2 max, const char* text) {
    const ImVec2 size = ImGui::CalcTextSize(text);
    const ImVec2 corner{(min.x + max.x - size.x) * 0.5f, (min.y + max.y - size.y) * 0.5f};
    ImGui::GetWindowDrawList()->AddText(corner, ImGui::GetColorU32(theme::kTextDim), text);
}

}  // namespace

void ImageView::placeImage(const Workspace& workspace, Vec2 min, Vec2 max) {
    const Resolution& size = workspace.document.draft().resolution;
    const Vec2 film(static_cast<float>(std::max(size.width, 1)),
                    static_cast<float>(std::max(size.height, 1)));
    const Vec2 room = max - min;
    const float fit = std::min(room.x / film.x, room.y / film.y);
    const ImVec2 pixelScale = ImGui::GetIO().DisplayFramebufferScale;
    zoom_ = workspace.display.pixelScale ? 1.0f / std::max(pixelScale.x, 1.0f) : fit;
    const Vec2 shown = film * zoom_;
    imageMin_ = {std::floor(min.x + (room.x - shown.x) * 0.5f),
                 std::floor(min.y + (room.y - shown.y) * 0.5f)};
    imageMax_ = imageMin_ + shown;
}

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

bool ImageView::navigate(Camera* camera, bool hovered, bool held) {
    const ImGuiIO& io = ImGui::GetIO();
    const float height = imageMax_.y - imageMin_.y;
    const Vec2 delta = dragged(held);
    if (!isZero(Vec3(delta, 0.0f))) {
        if (!ImGui::IsMouseDown(ImGuiMouseButton_Left) || io.KeyShift) {
            pan(camera, delta, height);
        } else if (io.KeyCtrl) {
            lookAround(camera, delta, height);
        } else {
            orbit(camera, delta, height);
        }
    }
    if (hovered && io.MouseWheel != 0.0f) {
        dolly(camera, io.MouseWheel);
        lastWheel_ = ImGui::GetTime();
    }
    const Vec3 direction = flyDirection();
    const bool flying = !isZero(direction);
    if (flying) {
        const float speed = kFlySpeed * (io.KeyShift ? kFastFactor : 1.0f);
        fly(camera, direction * (speed * std::min(io.DeltaTime, 0.1f)));
    }
    return isDragging_ || flying || (lastWheel_ >= 0.0 && ImGui::GetTime() - lastWheel_ < kWheelHoldSeconds);
}

/// Which pixel the mouse is on, and on whose side.
void ImageView::findPixel(const Workspace& workspace) {
    const Vec2 mouse(ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y);
    const bool isInside =
        glm::all(glm::greaterThanEqual(mouse, imageMin_)) && glm::all(glm::lessThan(mouse, imageMax_));
    if (!isInside) { return; }
    hoveredPixel_ = Vec2i((mouse - imageMin_) / zoom_);
    const bool onRight = mouse.x > imageMin_.x + (imageMax_.x - imageMin_.x) * workspace.display.splitAt;
    const bool ownIsRight = workspace.document.draft().options.integrator == workspace.comparedPair().right;
    hoversOther_ = workspace.display.split && onRight != ownIsRight;
}

/// Focuses by Ctrl + click, by a click once the panel asked for one, or by T; any other click selects.
void ImageView::pick(Workspace* workspace, bool isClick) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool picks = workspace->lens.picksFocus;
    if (picks && hoveredPixel_) { ImGui::SetMouseCursor(ImGuiMouseCursor_Hand); }
    const bool isKey = !io.WantTextInput && !io.KeyCtrl && ImGui::IsKeyPressed(GLFW_KEY_T, false);
    const bool isWanted = isKey || (isClick && (picks || io.KeyCtrl));
    if (!hoveredPixel_) { return; }
    workspace->inspector.pixel = hoveredPixel_;
    if (isWanted) {
        workspace->focusAt(*hoveredPixel_);
    } else if (isClick) {
        workspace->selectAt(*hoveredPixel_);
    }
}

void ImageView::drawOverlay(const FocusOverlay& overlay, const ImageDisplay& display) const {
    if (overlay.colors().empty() || display.texture() == 0) { return; }
    ImGui::GetWindowDrawList()->AddImage(
        reinterpret_cast<ImTextureID>(static_cast<intptr_t>(display.texture())), {imageMin_.x, imageMin_.y},
        {imageMax_.x, imageMax_.y});
}

bool ImageView::draw(Workspace* workspace, const ImagePanes& panes, Vec2 min, Vec2 max) {
    const bool hasScene = workspace->document.isOpen();
    ImGui::SetNextWindowPos({min.x, min.y});
    ImGui::SetNextWindowSize({max.x - min.x, max.y - min.y});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
    ImGui::PushStyleColor(ImGuiCol_WindowBg, theme::kImageBackground);
    ImGui::Begin("##image", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollWithMouse);
    if (hasScene) { placeImage(*workspace, min, max); }
    if (hasScene && workspace->display.split) { dragDivider(&workspace->display, imageMin_, imageMax_); }
    ImGui::SetCursorScreenPos({min.x, min.y});
    // A click on the image takes the keyboard back from a text field.
    const bool isReleased =
        ImGui::InvisibleButton("##area", {max.x - min.x, max.y - min.y},
                               ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                                   ImGuiButtonFlags_MouseButtonMiddle);
    const bool isClick = isReleased && !isDragging_ && ImGui::IsMouseReleased(ImGuiMouseButton_Left);
    const bool hovered = ImGui::IsItemHovered();
    const bool held = ImGui::IsItemActive();
    hoveredPixel_.reset();
    bool moving = false;
    if (hasScene) {
        moving = navigate(&workspace->document.draft().camera, hovered, held);
        if (panes.own.display->texture() != 0) {
            drawPanes(*workspace, panes, imageMin_, imageMax_);
            drawOverlay(workspace->focusOverlay, *panes.overlay);
        } else {
            drawHint(min, max, "Building…");
        }
        if (hovered) { findPixel(*workspace); }
        pick(workspace, isClick);
    } else {
        drawHint(
            min, max,
            workspace->sceneFiles.opening() ? "Opening…" : "No scene is open. Enter a file on the right.");
    }
    ui::area("Image", min, max, "");
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    return moving;
}

}  // namespace glint
