// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <imgui.h>

#include "luxel/viewer/layout.h"
#include "luxel/viewer/panels.h"
#include "luxel/viewer/plot.h"

namespace luxel {
namespace {

std::string short_time(double seconds) {
  if (seconds < 60.0) return fmt::format("{:.1f} s", seconds);
  if (seconds < 3600.0)
    return fmt::format("{}:{:02} min", static_cast<int>(seconds) / 60, static_cast<int>(seconds) % 60);
  return fmt::format("{:.1f} h", seconds / 3600.0);
}

std::string short_count(double count) {
  if (count < 1e3) return fmt::format("{:.0f}", count);
  if (count < 1e6) return fmt::format("{:.1f} k", count * 1e-3);
  if (count < 1e9) return fmt::format("{:.1f} M", count * 1e-6);
  return fmt::format("{:.1f} G", count * 1e-9);
}

void progress(const SessionStatus& status) {
  const auto stage = status.is_paused       ? std::string("paused")
                     : status.stage.empty() ? std::string(status.stop ? description(*status.stop) : "ready")
                                            : status.stage;
  ImGui::ProgressBar(static_cast<float>(status.stage.empty() ? 1.0 : status.done), ImVec2(-1.0f, 0.0f), "");
  const auto low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const auto size = ImGui::CalcTextSize(stage.c_str());
  ImGui::GetWindowDrawList()->AddText(
      ImVec2(0.5f * (low.x + high.x - size.x), 0.5f * (low.y + high.y - size.y)),
      IM_COL32(240, 240, 240, 255), stage.c_str());
  if (status.rays > 0) {
    const auto rate =
        status.rays_per_second > 0.0 ? fmt::format(", {}/s", short_count(status.rays_per_second)) : "";
    ImGui::Text("%s rays in %s%s", short_count(static_cast<double>(status.rays)).c_str(),
                short_time(status.seconds).c_str(), rate.c_str());
  }
  const auto asked =
      status.error_asked > 0.0 ? fmt::format(" of {:.2g} % requested", 100.0 * status.error_asked) : "";
  if (status.error > 0.0)
    ImGui::Text("%s error %.2f %%%s", status.is_seen ? "seen" : "standard", 100.0 * status.error,
                asked.c_str());
  if (status.seconds_left && !status.is_idle)
    ImGui::Text("about %s left", short_time(*status.seconds_left).c_str());
}

void convergence(const SessionStatus& status) {
  std::vector<PlotPoint> points;
  for (const auto& p : status.history)
    if (p.error > 0.0) points.push_back({p.seconds, p.error});
  if (points.size() < 2) return;
  plot(points,
       {.logarithmic = true, .line = status.error_asked, .x_unit = "s", .y_unit = " %", .percent = true});
}

void buttons(Viewer& viewer, const SessionStatus& status) {
  auto& live = *viewer.session;
  if (ImGui::Button(status.is_paused ? "Resume" : "Pause", ImVec2(em(4.6f), 0.0f)))
    status.is_paused ? live.resume() : live.pause();
  ImGui::SameLine();
  if (ImGui::Button("Stop", ImVec2(em(3.4f), 0.0f))) live.stop();
  ImGui::SameLine();
  bool is_stepping = status.is_stepping;
  if (ImGui::Checkbox("by step", &is_stepping)) live.set_stepping(is_stepping);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("wait after every bounce, or doubling of the samples");
  ImGui::SameLine();
  if (ImGui::Button("Step")) live.step();
}

void method(Viewer& viewer, const SessionStatus& status) {
  if (ImGui::BeginCombo("method", status.method.c_str())) {
    for (const auto each : all_methods()) {
      if (ImGui::Selectable(std::string(name(each)).c_str(), status.method == name(each)))
        viewer.solve_by(each);
      if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(description(each)).c_str());
    }
    ImGui::EndCombo();
  }
  if (status.method != name(Method::sampled)) return;
  auto per_cent = static_cast<float>(100.0 * status.error_asked);
  ImGui::InputFloat("error asked, %", &per_cent, 0.0f, 0.0f, "%.3g");
  if (ImGui::IsItemDeactivatedAfterEdit() && per_cent > 0.0f && per_cent < 100.0f)
    viewer.session->set_error(0.01 * static_cast<double>(per_cent));
}

}  // namespace

void solver_section(Viewer& viewer) {
  if (!viewer.session.has_scene()) {
    ImGui::TextWrapped("%s",
                       viewer.session.is_busy() ? "reading" : "Drop a scene (OBJ, glTF) or a solution here.");
    return;
  }
  ImGui::TextUnformatted(viewer.session.title().c_str());
  const auto& status = viewer.session.status();
  if (const auto& mesh = viewer.session.mesh()) {
    ImGui::SameLine();
    ImGui::TextDisabled("%s patches", short_count(static_cast<double>(mesh->patches->size())).c_str());
  }
  progress(status);
  convergence(status);
  buttons(viewer, status);
  method(viewer, status);
}

}  // namespace luxel
