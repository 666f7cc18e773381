// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <fmt/format.h>
#include <imgui.h>

#include "luxel/image/image.h"
#include "luxel/viewer/layout.h"
#include "luxel/viewer/panels.h"

namespace luxel {
namespace {

bool lamp_sliders(LightMixer& board) {
  bool changed = false;
  for (auto& lamps : board.lamps) {
    ImGui::PushID(&lamps);
    ImGui::SetNextItemWidth(em(8.0f));
    changed |= ImGui::SliderFloat("##factor", &lamps.factor, 0.0f, 4.0f, "x %.2f");
    ImGui::SameLine();
    changed |=
        ImGui::ColorEdit3("##tint", &lamps.tint.r, ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_Float);
    ImGui::SameLine();
    ImGui::TextUnformatted(lamps.name.c_str());
    ImGui::PopID();
  }
  return changed;
}

// The picker shows sRGB codes; reflectances are linear.
bool colour_pickers(LightMixer& board) {
  bool changed = false;
  for (auto& surface : board.materials) {
    ImGui::PushID(&surface);
    Vec3 code(srgb_encode(surface.colour.r), srgb_encode(surface.colour.g), srgb_encode(surface.colour.b));
    if (ImGui::ColorEdit3("##colour", &code.r, ImGuiColorEditFlags_NoInputs)) {
      surface.colour = glm::min(Vec3(srgb_decode(code.r), srgb_decode(code.g), srgb_decode(code.b)),
                                Vec3(max_reflectance));
      changed = true;
    }
    ImGui::SameLine();
    ImGui::TextUnformatted(surface.name.c_str());
    ImGui::PopID();
  }
  return changed;
}

// Where the light of single lamps is not available, a button solves again with these settings.
void solve_button(Viewer& viewer, const std::string& method) {
  ImGui::TextWrapped(
      "Light of the method %s does not know its lamps apart: it is solved again for what is set here.",
      method.c_str());
  const bool is_set = viewer.light.mixer == viewer.light.sent;
  if (is_set) ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 0.4f);
  if (ImGui::Button("Solve with these") && !is_set) viewer.relight();
  if (is_set) ImGui::PopStyleVar();
}

}  // namespace

void lamps_section(Viewer& viewer) {
  if (!viewer.session.mesh() || !ImGui::CollapsingHeader("Lamps and colours")) return;
  const auto& status = viewer.session.status();
  const bool is_coming = status.method == name(Method::sampled) && !status.is_idle;
  if (!status.can_relight && (is_coming || !viewer.session.light())) {
    ImGui::TextWrapped(
        "Once the light is there, lamps and colours can be changed: sampled light without another ray.");
    if (!viewer.light.mixer.is_untouched()) ImGui::TextWrapped("It will have those that were set.");
    return;
  }
  if (!status.can_relight) solve_button(viewer, status.method);
  bool changed = lamp_sliders(viewer.light.mixer);
  ImGui::Separator();
  changed |= colour_pickers(viewer.light.mixer);
  if (!viewer.light.mixer.is_untouched() && ImGui::Button("As they were")) {
    viewer.light.mixer = LightMixer(*viewer.session.mesh()->patches);
    changed = true;
  }
  if (changed && status.can_relight) viewer.relight();
}

}  // namespace luxel
