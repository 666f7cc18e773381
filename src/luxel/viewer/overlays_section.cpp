// SPDX-License-Identifier: Apache-2.0
#include <imgui.h>

#include "luxel/image/image.h"
#include "luxel/patch/luminaire_groups.h"
#include "luxel/viewer/layout.h"
#include "luxel/viewer/panels.h"

namespace luxel {
namespace {

// The light bounce by bounce, from existing samples: no rays are traced.
void bounce_choice(Viewer& viewer) {
  if (!viewer.session.status().can_relight) return;
  bool all = !viewer.light.bounces.has_value();
  if (ImGui::Checkbox("all bounces", &all)) viewer.show_bounces(all ? std::nullopt : std::optional(1));
  if (!viewer.light.bounces) return;
  int count = *viewer.light.bounces;
  if (ImGui::SliderInt("bounces", &count, 0, 20)) viewer.show_bounces(count);
}

void fault_list(const Viewer& viewer) {
  if (!viewer.session.mesh()->scene) {
    ImGui::TextWrapped("A solution's file has no scene to be checked.");
    return;
  }
  const auto& report = viewer.queries.diagnostics;
  if (!report) {
    ImGui::TextDisabled("looking");
    return;
  }
  if (report->diagnostics.empty()) ImGui::TextDisabled("nothing is the matter");
  for (const auto& diagnostic : report->diagnostics) {
    const auto linear = colour(diagnostic.kind).linear;
    ImGui::ColorButton("##colour",
                       ImVec4(srgb_encode(linear.r), srgb_encode(linear.g), srgb_encode(linear.b), 1.0f),
                       ImGuiColorEditFlags_NoTooltip, ImVec2(em(0.7f), em(0.7f)));
    ImGui::SameLine();
    ImGui::TextWrapped("%s", diagnostic.fact.c_str());
  }
}

}  // namespace

void overlays_section(Viewer& viewer) {
  if (!viewer.session.mesh() || !ImGui::CollapsingHeader("Overlays")) return;
  auto& look = viewer.look;
  ImGui::Checkbox("patch edges", &look.wires);
  ImGui::SameLine(em(10.0f));
  ImGui::Checkbox("normals", &look.normals);
  ImGui::Checkbox("rays of a patch", &look.rays);
  ImGui::SameLine(em(10.0f));
  ImGui::Checkbox("its rays to lamps", &look.samples);
  ImGui::Checkbox("boxes", &look.boxes);
  ImGui::SameLine(em(10.0f));
  ImGui::Checkbox("faults", &look.diagnostics);
  if (has_luminaires(*viewer.session.mesh()->patches)) ImGui::Checkbox("photometric solids", &look.solids);
  if (look.boxes) ImGui::SliderInt("level", &look.box_level, 0, 24);
  bounce_choice(viewer);
  if (look.diagnostics) fault_list(viewer);
}

}  // namespace luxel
