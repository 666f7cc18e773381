// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <imgui.h>

#include "luxel/window/panels.h"

namespace luxel {

void instruments_section(Viewer& viewer) {
  if (!viewer.session.mesh() || !ImGui::CollapsingHeader("Instruments")) return;
  auto& look = viewer.look;
  ImGui::Checkbox("patch edges", &look.wires);
  ImGui::SameLine(150.0f);
  ImGui::Checkbox("normals", &look.normals);
  ImGui::Checkbox("boxes of the hierarchy", &look.boxes);
  if (look.boxes)
    ImGui::SliderInt("level", &look.box_level, 0, std::max(1, viewer.instruments.box_levels() - 1));
}

}  // namespace luxel
