#include "viewer/panels/portal_rows.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "viewer/ui/widgets.h"

namespace glint {
namespace {

/// Counter-clockwise as seen from its front.
std::vector<Vec3> cornersOf(const Object& rectangle) {
    std::vector<Vec3> corners;
    for (const Vec3& corner : {Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(1, 1, 0), Vec3(-1, 1, 0)}) {
        corners.push_back(rectangle.objectToWorld.point(corner));
    }
    return corners;
}

void drawPlace(float speed, std::vector<Vec3>* corners) {
    const Vec3 middle = 0.25f * (((*corners)[0] + (*corners)[1]) + ((*corners)[2] + (*corners)[3]));
    Vec3 moved = middle;
    if (ui::vector3("Portal at", &moved,
                    {.format = "%.3f", .speed = speed, .tooltip = "Its middle, metres", .unit = "m"})) {
        for (Vec3& corner : *corners) {
            corner += moved - middle;
        }
    }
    if (ui::button("Other side", ui::buttonWidth(1), "Turns over which side of the portal is lit")) {
        std::swap((*corners)[1], (*corners)[3]);
    }
}

}  // namespace

void drawPortalRows(SceneDocument* document) {
    std::vector<Vec3>& portal = document->draft().environment.portal;
    std::vector<std::string> names{"none"};
    std::vector<std::vector<Vec3>> choices{{}};
    if (!portal.empty()) {
        names.emplace_back("set");
        choices.push_back(portal);
    }
    const std::vector<Object>& objects = document->draft().objects;
    for (size_t i = 0; i < objects.size(); ++i) {
        if (objects[i].shape != ShapeKind::Rectangle) { continue; }
        std::vector<Vec3> corners = cornersOf(objects[i]);
        if (!isRectangle(corners)) { continue; }
        names.push_back(objects[i].name.empty() ? fmt::format("object {}", i) : objects[i].name);
        choices.push_back(std::move(corners));
    }
    const std::vector<std::string_view> views(names.begin(), names.end());
    int index = portal.empty() ? 0 : 1;
    if (ui::choice("Portal", &index, views,
                   "The rectangle through which alone the environment shines and is seen: one of the "
                   "scene's, whose front the light leaves")) {
        portal = choices[static_cast<size_t>(index)];
    }
    if (portal.empty()) { return; }
    const float speed = std::max(maxComponent(document->bounds().extent()) * 0.002f, 1e-4f);
    drawPlace(std::isfinite(speed) ? speed : 0.01f, &portal);
}

}  // namespace glint
