#include "viewer/panels/material_drag.h"

#include <imgui.h>

namespace glint {

void offerMaterial(const MaterialDrag& drag, const std::string& name) {
    if (!ImGui::BeginDragDropSource(ImGuiDragDropFlags_SourceNoHoldToOpenOthers)) { return; }
    ImGui::SetDragDropPayload(MaterialDrag::kKind, &drag, sizeof drag);
    ImGui::TextUnformatted(name.c_str());
    ImGui::EndDragDropSource();
}

}  // namespace glint
