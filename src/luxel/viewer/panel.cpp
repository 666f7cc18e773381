// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <imgui.h>

#include "luxel/viewer/layout.h"
#include "luxel/viewer/panels.h"

namespace luxel {

void panel(Viewer& viewer) {
  if (!viewer.look.panel) return;
  const auto& display = ImGui::GetIO().DisplaySize;
  const float top = viewer.top() + em(0.6f), width = panel_width();
  ImGui::SetNextWindowPos(ImVec2(em(0.6f), top), ImGuiCond_Always);
  ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0.0f), ImVec2(width, display.y - top - em(2.7f)));
  ImGui::Begin("Luxel", nullptr,
               ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoTitleBar |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::PushItemWidth(em(10.0f));
  solver_section(viewer);
  look_section(viewer);
  lamps_section(viewer);
  overlays_section(viewer);
  views_section(viewer);
  files_section(viewer);
  ImGui::PopItemWidth();
  ImGui::End();
}

void dialogs(Viewer& viewer) {
  if (viewer.notices.dialog() == nullptr) return;
  if (!ImGui::IsPopupOpen("That did not work")) ImGui::OpenPopup("That did not work");
  const auto& display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(display.x * 0.5f, display.y * 0.5f), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
  ImGui::SetNextWindowSize(ImVec2(std::min(em(32.0f), display.x - em(1.0f)), 0.0f));
  if (!ImGui::BeginPopupModal("That did not work", nullptr, ImGuiWindowFlags_AlwaysAutoResize)) return;
  ImGui::TextWrapped("%s", viewer.notices.dialog()->c_str());
  ImGui::Spacing();
  if (ImGui::Button("Go on", ImVec2(em(7.0f), 0.0f)) ||
      ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter)) ||
      ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) {
    viewer.notices.close_dialog();
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

}  // namespace luxel
