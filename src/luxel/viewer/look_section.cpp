// SPDX-License-Identifier: Apache-2.0
#include <array>

#include <imgui.h>

#include "luxel/viewer/panels.h"
#include "luxel/viewer/side_values.h"

namespace luxel {
namespace {

void show_choice(Look& look) {
  if (!ImGui::BeginCombo("show", heading_of(look.show))) return;
  for (int i = 0; i < show_count; ++i) {
    const auto each = static_cast<Show>(i);
    if (ImGui::Selectable(heading_of(each), look.show == each)) look.show = each;
  }
  ImGui::EndCombo();
}

void tone_choice(Look& look) {
  const std::array<ToneOperator, 5> operators = {ToneOperator::neutral, ToneOperator::reinhard,
                                                 ToneOperator::reinhard_local, ToneOperator::maximum,
                                                 ToneOperator::clamp};
  if (ImGui::BeginCombo("tone", name(look.tone.op).data())) {
    for (const auto each : operators)
      if (ImGui::Selectable(name(each).data(), look.tone.op == each)) look.tone.op = each;
    ImGui::EndCombo();
  }
  ImGui::SliderFloat("exposure, stops", &look.tone.exposure, -10.0f, 10.0f, "%+.2f");
  ImGui::Checkbox("follow what is in view", &look.automatic_exposure);
}

void scale_choice(const Viewer& viewer, Look& look) {
  if (*unit_of(look.show, true) == 'l') {
    int unit = look.lux ? 0 : 1;
    ImGui::RadioButton("lux", &unit, 0);
    ImGui::SameLine();
    ImGui::RadioButton("W/m\u00b2", &unit, 1);
    ImGui::SameLine();
    look.lux = unit == 0;
  }
  ImGui::Checkbox("logarithmic", &look.logarithmic);
  ImGui::Checkbox("scale by itself", &look.automatic_scale);
  if (look.automatic_scale) {
    // A manual scale begins with the ends of the current one.
    if (const auto scale = viewer.painter().scale()) look.low = scale->low, look.high = scale->high;
  } else {
    ImGui::InputFloat("from", &look.low, 0.0f, 0.0f, "%.4g");
    ImGui::InputFloat("to", &look.high, 0.0f, 0.0f, "%.4g");
  }
  if (look.show == Show::irradiance) ImGui::SliderInt("isolines", &look.isolines, 0, 20);
}

}  // namespace

void look_section(Viewer& viewer) {
  if (!ImGui::CollapsingHeader("Look", ImGuiTreeNodeFlags_DefaultOpen)) return;
  auto& look = viewer.look;
  show_choice(look);
  if (look.show == Show::light) tone_choice(look);
  if (viewer.painter().scale()) scale_choice(viewer, look);
  if (look.show == Show::difference && viewer.queries.compared_with.empty())
    ImGui::TextWrapped("There is no second solution yet: see Files.");
}

void views_section(Viewer& viewer) {
  if (!ImGui::CollapsingHeader("Views")) return;
  if (ImGui::Button("Home")) viewer.camera.home();
  for (std::size_t i = 0; i < CameraController::views; ++i) {
    const char label[] = {static_cast<char>('1' + i), '\0'};
    if (i > 0) ImGui::SameLine();
    if (!viewer.camera.has_view(i)) ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 0.4f);
    const bool is_empty = !viewer.camera.has_view(i);
    if (ImGui::SmallButton(label)) {
      if (is_empty || ImGui::GetIO().KeyCtrl) {
        viewer.camera.save_view(i);
      } else {
        viewer.camera.recall_view(i);
      }
    }
    if (is_empty) ImGui::PopStyleVar();
  }
  ImGui::TextDisabled("an empty one keeps this view; Ctrl: anew");
}

}  // namespace luxel
