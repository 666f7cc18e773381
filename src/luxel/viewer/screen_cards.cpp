// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>

#include <fmt/format.h>
#include <imgui.h>

#include "luxel/image/image.h"
#include "luxel/viewer/panels.h"
#include "luxel/viewer/plot.h"
#include "luxel/viewer/side_values.h"

namespace luxel {
namespace {

constexpr auto still = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoInputs |
                       ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav |
                       ImGuiWindowFlags_AlwaysAutoResize;

// The more one needs them, the earlier: a narrow window shows the first and the last.
constexpr std::array keys_free = {
    "drag: turn",         "wheel: exposure", "Tab fly", "right drag: look", "Shift+wheel: nearer",
    "middle drag: shift", "F focus",         "H home",  "F1 keys"};
constexpr std::array keys_flying = {"mouse: look",   "W A S D: go",  "Q E: down, up", "Tab: free the mouse",
                                    "Shift: faster", "wheel: speed", "F focus",       "H home",
                                    "F1 keys"};

constexpr const char* all_keys =
    "Tab           fly, or free the mouse        Space   pause the solver, go on\n"
    "W A S D       forward, left, back, right    L       light\n"
    "Q E           down, up                      I       irradiance in false colours\n"
    "Shift         faster                        O       the next thing to show\n"
    "F             focus on what is there        T       the next tone curve\n"
    "H             home                          X       exposure follows the view, or stays\n"
    "1 to 9        back to a saved view          G       patch edges\n"
    "Ctrl 1 to 9   save this view                N B R   normals, boxes, rays\n"
    "click         pin the probe                 P       the panel\n"
    "Shift drag    light along a line            F12     a picture\n"
    "Escape        clear probe and line          F1      these keys";

ImU32 screen_colour(const Vec3& linear) {
  return IM_COL32(srgb_code(linear.r), srgb_code(linear.g), srgb_code(linear.b), 255);
}

// Side by side, as many as the window is wide for; the last always.
void words(std::span<const char* const> all, float width) {
  constexpr float gap = 20.0f;
  const auto width_of = [](const char* text) { return ImGui::CalcTextSize(text).x; };
  float left = width - width_of(all.back());
  for (const char* each : all.first(all.size() - 1)) {
    left -= width_of(each) + gap;
    if (left < 0.0f) break;
    ImGui::TextUnformatted(each);
    ImGui::SameLine(0.0f, gap);
  }
  ImGui::TextUnformatted(all.back());
}

void value_line(const char* what, const LightValue& value) {
  const auto with_error = [](double number, const std::optional<double>& error, const char* unit) {
    if (!error) return fmt::format("{} {}", scale_text(static_cast<float>(number)), unit);
    return fmt::format("{} \u00b1 {} {}", scale_text(static_cast<float>(number)),
                       scale_text(static_cast<float>(1.96 * *error)), unit);
  };
  ImGui::Text("%-12s%s", what, with_error(value.lux, value.lux_error, "lux").c_str());
  ImGui::Text("%-12s%s", "", with_error(value.watts, value.watts_error, "W/m\u00b2").c_str());
}

bool shows_probe(const Viewer& viewer) {
  return viewer.light_probe.probe() && (viewer.light_probe.is_pinned() || viewer.look.show != Show::light);
}

void place_text(const Probe& probe) {
  ImGui::Text("%-12s%u, %s side", "patch", probe.patch, probe.back ? "back" : "front");
  ImGui::Text("%-12s%.3g m\u00b2, longest edge %.3g m", "", probe.area, probe.longest_edge);
  ImGui::Text("%-12s%s", "material", probe.material.c_str());
  ImGui::Text("%-12s%u%s", "triangle", probe.triangle,
              probe.line > 0 ? fmt::format(", line {}", probe.line).c_str() : "");
  if (!probe.group.empty()) ImGui::Text("%-12s%s", "group", probe.group.c_str());
  ImGui::Text("%-12s%.3f, %.3f, %.3f m", "at", probe.at.x, probe.at.y, probe.at.z);
}

}  // namespace

void key_line(const Viewer& viewer) {
  const auto& display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(display.x * 0.5f, display.y - 6.0f), ImGuiCond_Always, ImVec2(0.5f, 1.0f));
  ImGui::SetNextWindowBgAlpha(0.6f);
  ImGui::Begin("##keys", nullptr, still);
  const float width = display.x - 40.0f;
  if (!viewer.notices.said().empty()) {
    ImGui::PushTextWrapPos(std::min(width, ImGui::CalcTextSize(viewer.notices.said().c_str()).x + 20.0f));
    ImGui::TextColored(ImVec4(1.0f, 0.78f, 0.3f, 1.0f), "%s", viewer.notices.said().c_str());
    ImGui::PopTextWrapPos();
  }
  viewer.camera.is_flying() ? words(keys_flying, width) : words(keys_free, width);
  ImGui::End();
  if (!viewer.look.help) return;
  ImGui::SetNextWindowPos(ImVec2(display.x * 0.5f, display.y * 0.5f), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
  ImGui::SetNextWindowBgAlpha(1.0f);  // the panel may lie below
  ImGui::Begin("##help", nullptr, still);
  ImGui::TextUnformatted(all_keys);
  ImGui::End();
}

void legend(const Viewer& viewer) {
  const auto scale = viewer.painter().scale();
  if (!scale) return;
  const auto& look = viewer.look;
  const auto& display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(display.x - 10.0f, 10.0f), ImGuiCond_Always, ImVec2(1.0f, 0.0f));
  ImGui::Begin("##legend", nullptr, still);
  ImGui::Text("%s%s%s", heading_of(look.show), *unit_of(look.show, look.lux) != '\0' ? ", " : "",
              unit_of(look.show, look.lux));
  constexpr float height = 220.0f, width = 22.0f;
  const auto place = ImGui::GetCursorScreenPos();
  auto& list = *ImGui::GetWindowDrawList();
  const float text = ImGui::GetTextLineHeight();
  const float top = place.y + 0.5f * text;
  constexpr int steps = 110;
  for (int i = 0; i < steps; ++i) {
    const float fraction = (static_cast<float>(i) + 0.5f) / steps;
    const float y = top + height * (1.0f - static_cast<float>(i + 1) / steps);
    list.AddRectFilled(ImVec2(place.x, y), ImVec2(place.x + width, y + height / steps + 0.5f),
                       screen_colour(map_colour(scale->map, fraction)));
  }
  const int marks = look.show == Show::irradiance && scale->isolines > 0 ? scale->isolines + 1 : 5;
  for (int i = 0; i <= marks; ++i) {
    const float fraction = static_cast<float>(i) / static_cast<float>(marks);
    const float y = top + height * (1.0f - fraction);
    list.AddLine(ImVec2(place.x + width, y), ImVec2(place.x + width + 4.0f, y), IM_COL32(220, 220, 220, 255));
    list.AddText(ImVec2(place.x + width + 8.0f, y - 0.5f * text), IM_COL32(220, 224, 230, 255),
                 scale_text(scale->value_at(fraction)).c_str());
  }
  ImGui::Dummy(ImVec2(width + 70.0f, height + text));
  ImGui::End();
}

void probe_card(const Viewer& viewer) {
  const auto& probe = viewer.light_probe.probe();
  if (!shows_probe(viewer)) return;
  const auto& display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(display.x - 10.0f, display.y - 40.0f), ImGuiCond_Always, ImVec2(1.0f, 1.0f));
  ImGui::Begin("##probe", nullptr, still);
  ImGui::TextDisabled(viewer.light_probe.is_pinned() ? "pinned; Escape lets go"
                                                     : "under the cursor; a click pins it");
  if (probe->irradiance) value_line("irradiance", *probe->irradiance);
  if (probe->radiosity) value_line("radiosity", *probe->radiosity);
  place_text(*probe);
  ImGui::End();
}

void profile_card(Viewer& viewer) {
  if (viewer.line) {
    const auto& display = ImGui::GetIO().DisplaySize;
    const auto at = [&](const Vec2& p) {
      return ImVec2((p.x + 1.0f) * 0.5f * display.x, (1.0f - p.y) * 0.5f * display.y);
    };
    ImGui::GetBackgroundDrawList()->AddLine(at(viewer.line->first), at(viewer.line->second),
                                            IM_COL32(255, 190, 60, 255), 2.0f);
  }
  const auto& profile = viewer.light_probe.profile();
  if (profile.empty()) return;
  const bool lux = viewer.look.lux;
  std::vector<PlotPoint> points;
  for (const auto& p : profile) {
    const auto& error = lux ? p.irradiance.lux_error : p.irradiance.watts_error;
    points.push_back(
        {p.along, lux ? p.irradiance.lux : p.irradiance.watts, 1.96 * error.value_or(0.0), !p.is_lit});
  }
  const auto& display = ImGui::GetIO().DisplaySize;
  // Below; or, where the probe's card is there, above, between the panel and the legend.
  constexpr float left_of_it = 320.0f, right_of_it = 130.0f;
  if (shows_probe(viewer))
    ImGui::SetNextWindowPos(ImVec2(0.5f * (left_of_it + display.x - right_of_it), 10.0f), ImGuiCond_Always,
                            ImVec2(0.5f, 0.0f));
  else
    ImGui::SetNextWindowPos(ImVec2(display.x * 0.5f, display.y - 40.0f), ImGuiCond_Always,
                            ImVec2(0.5f, 1.0f));
  ImGui::Begin("##profile", nullptr, still);
  ImGui::Text("Irradiance along the line, %s; the band holds the truth 95 times in 100",
              lux ? "lux" : "W/m\u00b2");
  plot(points, {.width = 460.0f, .height = 150.0f, .x_unit = "m"});
  ImGui::End();
}

}  // namespace luxel
