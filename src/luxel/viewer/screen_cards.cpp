// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>

#include <fmt/format.h>
#include <imgui.h>

#include "luxel/image/image.h"
#include "luxel/viewer/layout.h"
#include "luxel/viewer/panels.h"
#include "luxel/viewer/plot.h"
#include "luxel/viewer/side_values.h"

namespace luxel {
namespace {

ImU32 screen_colour(const Vec3& linear) {
  return IM_COL32(srgb_code(linear.r), srgb_code(linear.g), srgb_code(linear.b), 255);
}

// A name, and what it is.
void row(const char* name, const std::string& text) {
  ImGui::TextUnformatted(name);
  ImGui::SameLine(em(6.0f));
  ImGui::TextUnformatted(text.c_str());
}

void value_line(const char* what, const LightValue& value) {
  const auto with_error = [](double number, const std::optional<double>& error, const char* unit) {
    if (!error) return fmt::format("{} {}", scale_text(static_cast<float>(number)), unit);
    return fmt::format("{} \u00b1 {} {}", scale_text(static_cast<float>(number)),
                       scale_text(static_cast<float>(1.96 * *error)), unit);
  };
  row(what, with_error(value.lux, value.lux_error, "lux"));
  row("", with_error(value.watts, value.watts_error, "W/m\u00b2"));
}

bool shows_surface(const Viewer& viewer) {
  return viewer.light_probe.probe() && (viewer.light_probe.is_pinned() || viewer.look.show != Show::light);
}

bool shows_probe(const Viewer& viewer) { return viewer.light_probe.luminaire() || shows_surface(viewer); }

void luminaire_text(const SeenLuminaire& luminaire) {
  row("luminaire", luminaire.name);
  if (luminaire.file != luminaire.name) row("", luminaire.file);
  if (!luminaire.group.empty() && luminaire.group != luminaire.name) row("light group", luminaire.group);
  row("flux", fmt::format("{:.0f} lm", luminaire.lumens));
}

void place_text(const Probe& probe) {
  row("patch", fmt::format("{}, {} side", probe.patch, probe.back ? "back" : "front"));
  row("", fmt::format("{:.3g} m\u00b2, longest edge {:.3g} m", probe.area, probe.longest_edge));
  row("material", probe.material);
  row("triangle",
      fmt::format("{}{}", probe.triangle, probe.line > 0 ? fmt::format(", line {}", probe.line) : ""));
  if (!probe.group.empty()) row("group", probe.group);
  row("at", fmt::format("{:.3f}, {:.3f}, {:.3f} m", probe.at.x, probe.at.y, probe.at.z));
}

void surface_text(const Probe& probe) {
  if (probe.irradiance) value_line("irradiance", *probe.irradiance);
  if (probe.radiosity) value_line("radiosity", *probe.radiosity);
  place_text(probe);
}

}  // namespace

void legend(const Viewer& viewer) {
  const auto scale = viewer.painter().scale();
  if (!scale) return;
  const auto& look = viewer.look;
  const auto& display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(display.x - em(0.6f), viewer.top() + em(0.6f)), ImGuiCond_Always,
                          ImVec2(1.0f, 0.0f));
  ImGui::Begin("##legend", nullptr, still_card);
  ImGui::Text("%s%s%s", heading_of(look.show), *unit_of(look.show, look.lux) != '\0' ? ", " : "",
              unit_of(look.show, look.lux));
  const float height = em(15.0f), width = em(1.5f), mark = em(0.3f);
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
    list.AddLine(ImVec2(place.x + width, y), ImVec2(place.x + width + mark, y), IM_COL32(220, 220, 220, 255));
    list.AddText(ImVec2(place.x + width + 2.0f * mark, y - 0.5f * text), IM_COL32(220, 224, 230, 255),
                 scale_text(scale->value_at(fraction)).c_str());
  }
  ImGui::Dummy(ImVec2(width + em(4.7f), height + text));
  ImGui::End();
}

void probe_card(const Viewer& viewer) {
  if (!shows_probe(viewer)) return;
  const auto& display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(display.x - em(0.6f), display.y - em(2.7f)), ImGuiCond_Always,
                          ImVec2(1.0f, 1.0f));
  ImGui::Begin("##probe", nullptr, still_card);
  ImGui::TextDisabled(viewer.light_probe.is_pinned() ? "pinned; Escape lets go"
                                                     : "under the cursor; a click pins it");
  const auto& luminaire = viewer.light_probe.luminaire();
  if (luminaire) luminaire_text(*luminaire);
  if (luminaire && shows_surface(viewer)) ImGui::Separator();
  if (shows_surface(viewer)) surface_text(*viewer.light_probe.probe());
  ImGui::End();
}

void profile_card(Viewer& viewer) {
  if (viewer.line) {
    const auto& display = ImGui::GetIO().DisplaySize;
    const auto at = [&](const Vec2& p) {
      return ImVec2((p.x + 1.0f) * 0.5f * display.x, (1.0f - p.y) * 0.5f * display.y);
    };
    ImGui::GetBackgroundDrawList()->AddLine(at(viewer.line->first), at(viewer.line->second),
                                            IM_COL32(255, 190, 60, 255), em(0.14f));
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
  // At the bottom, or at the top between the panel and the legend while the probe's card is shown.
  const float left_of_it = em(21.4f), right_of_it = em(8.7f);
  if (shows_probe(viewer))
    ImGui::SetNextWindowPos(ImVec2(0.5f * (left_of_it + display.x - right_of_it), viewer.top() + em(0.6f)),
                            ImGuiCond_Always, ImVec2(0.5f, 0.0f));
  else
    ImGui::SetNextWindowPos(ImVec2(display.x * 0.5f, display.y - em(2.7f)), ImGuiCond_Always,
                            ImVec2(0.5f, 1.0f));
  ImGui::Begin("##profile", nullptr, still_card);
  ImGui::Text("Irradiance along the line, %s; the band holds the truth 95 times in 100",
              lux ? "lux" : "W/m\u00b2");
  plot(points, {.width = 31.0f, .height = 10.0f, .x_unit = "m"});
  ImGui::End();
}

}  // namespace luxel
