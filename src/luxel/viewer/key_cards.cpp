// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <utility>

#include <imgui.h>

#include "luxel/viewer/layout.h"
#include "luxel/viewer/panels.h"

namespace luxel {
namespace {

// In order of importance: a narrow window shows the first ones and the last.
constexpr std::array keys_free = {"drag: turn",       "wheel: nearer",        "Tab: fly",
                                  "right drag: look", "middle drag: shift",   "F: focus",
                                  "H: home",          "Ctrl+wheel: exposure", "F1: keys"};
constexpr std::array keys_flying = {
    "mouse: look",   "W A S D: go",       "Q E: down, up", "Tab: free the mouse",
    "Shift: faster", "Ctrl+wheel: speed", "F: focus",      "H: home",
    "F1: keys"};

using KeyHelp = std::pair<const char*, const char*>;
constexpr std::array<KeyHelp, 17> keys_of_view = {
    {{"Tab", "fly, or free the mouse"},
     {"W A S D", "forward, left, back, right"},
     {"Q E", "down, up"},
     {"Shift", "faster"},
     {"drag", "turn about what is under the cursor"},
     {"right drag", "look around"},
     {"middle drag", "shift"},
     {"wheel, + \u2212", "nearer, further; flying: ahead, back"},
     {"Shift wheel", "the same, faster"},
     {"F", "focus on what is there"},
     {"H", "home"},
     {"1 to 9", "back to a saved view"},
     {"Ctrl 1 to 9", "save this view"},
     {"click", "pin the probe"},
     {"Shift drag", "light along a line"},
     {"Escape", "clear probe and line"},
     {"F11", "full screen"}}};
constexpr std::array<KeyHelp, 18> keys_of_light = {{{"Space", "pause the solver, go on"},
                                                    {"Ctrl Z", "undo a change of lamps or colours"},
                                                    {"Ctrl Shift Z", "redo it"},
                                                    {"Ctrl wheel", "exposure; flying: speed"},
                                                    {"Page Up, Down", "exposure"},
                                                    {"X", "exposure follows the view, or stays"},
                                                    {"T", "the next tone curve"},
                                                    {"L", "light"},
                                                    {"I", "irradiance in false colours"},
                                                    {"O", "the next thing to show"},
                                                    {"G", "patch edges"},
                                                    {"N B R", "normals, boxes, rays"},
                                                    {"C", "photometric solids of luminaires"},
                                                    {"P", "panel and menus"},
                                                    {"F12", "a picture"},
                                                    {"Ctrl O", "open a scene or a solution"},
                                                    {"Ctrl S, Ctrl E", "save the solution, export"},
                                                    {"F1", "these keys"}}};

// Side by side, as many as fit into the window; always the last one.
void words(std::span<const char* const> all, float width) {
  const float gap = em(1.3f);
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

void key_cells(const KeyHelp& help) {
  ImGui::TableNextColumn();
  ImGui::TextColored(ImVec4(1.0f, 0.78f, 0.3f, 1.0f), "%s", help.first);
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(help.second);
}

void begin_card(const char* name) {
  const auto& display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(display.x * 0.5f, display.y * 0.5f), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
  ImGui::SetNextWindowBgAlpha(1.0f);  // the panel may be below
  ImGui::Begin(name, nullptr, still_card);
}

}  // namespace

void key_line(const Viewer& viewer) {
  const bool reports = !viewer.notices.said().empty();
  if (!viewer.look.keys && !reports) return;
  const auto& display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(display.x * 0.5f, display.y - em(0.4f)), ImGuiCond_Always,
                          ImVec2(0.5f, 1.0f));
  ImGui::SetNextWindowBgAlpha(0.6f);
  ImGui::Begin("##keys", nullptr, still_card);
  const float width = display.x - em(2.7f);
  if (reports) {
    ImGui::PushTextWrapPos(std::min(width, ImGui::CalcTextSize(viewer.notices.said().c_str()).x + em(1.3f)));
    ImGui::TextColored(ImVec4(1.0f, 0.78f, 0.3f, 1.0f), "%s", viewer.notices.said().c_str());
    ImGui::PopTextWrapPos();
  }
  if (viewer.look.keys) viewer.camera.is_flying() ? words(keys_flying, width) : words(keys_free, width);
  ImGui::End();
}

void key_card(const Viewer& viewer) {
  if (!viewer.look.help) return;
  begin_card("##help");
  const auto flags = ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_NoHostExtendX;
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(em(0.6f), em(0.1f)));
  if (ImGui::BeginTable("##table", 4, flags)) {
    for (std::size_t i = 0; i < keys_of_light.size(); ++i) {
      key_cells(i < keys_of_view.size() ? keys_of_view[i] : KeyHelp{"", ""});
      key_cells(keys_of_light[i]);
    }
    ImGui::EndTable();
  }
  ImGui::PopStyleVar();
  ImGui::TextDisabled("F1 or Escape closes this.");
  ImGui::End();
}

void about_card(const Viewer& viewer) {
  if (!viewer.look.about) return;
  const auto driver = current_driver();
  begin_card("##about");
  ImGui::Text("Luxel %s", viewer.settings.version.c_str());
  ImGui::TextUnformatted("Global illumination of diffuse scenes by the radiosity method.");
  ImGui::TextUnformatted("Apache License 2.0");
  ImGui::Spacing();
  ImGui::TextDisabled("OpenGL %s, %s", driver.version.c_str(), driver.name.c_str());
  ImGui::TextDisabled("Escape closes this.");
  ImGui::End();
}

}  // namespace luxel
