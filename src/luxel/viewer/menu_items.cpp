// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "luxel/viewer/menus.h"
#include "luxel/viewer/side_values.h"
#include "luxel/viewer/viewer.h"

// The entries of each menu.

namespace luxel {
namespace {

using Items = std::vector<MenuItem>;
using Path = std::vector<std::string>;

void add_line(Items& items, const std::string& menu) { items.push_back({.path = {menu, ""}}); }

// A display choice; checked: its current state.
void add_switch(Items& items, Path path, const std::string& keys, bool Look::*place, const Look& look) {
  items.push_back({.path = std::move(path),
                   .keys = keys,
                   .choose = [place](Viewer& viewer) { viewer.look.*place = !(viewer.look.*place); },
                   .is_checked = look.*place});
}

void add_file_menu(const Viewer& viewer, Items& items) {
  const bool has_scene = viewer.session.has_scene(), has_light = viewer.session.light() != nullptr;
  items.push_back({{"File", "Open..."}, "Ctrl+O", [](Viewer& v) { v.ask_open(); }});
  const auto& recent = viewer.recent.files();
  if (recent.empty()) items.push_back({{"File", "Open recent", "none"}, "", [](Viewer&) {}, false});
  for (const auto& file : recent)
    items.push_back({{"File", "Open recent", file.string()}, "", [file](Viewer& v) { v.open(file); }});
  if (!recent.empty()) {
    items.push_back({{"File", "Open recent", ""}});
    items.push_back({{"File", "Open recent", "Clear the list"}, "", [](Viewer& v) { v.recent.clear(); }});
  }
  items.push_back({{"File", "Compare with..."}, "", [](Viewer& v) { v.ask_compare(); }, has_scene});
  add_line(items, "File");
  items.push_back(
      {{"File", "Save solution..."}, "Ctrl+S", [](Viewer& v) { v.ask_save_solution(); }, has_light});
  items.push_back({{"File", "Save picture..."}, "F12", [](Viewer& v) { v.ask_save_picture(); }, has_scene});
  items.push_back({{"File", "Export..."}, "Ctrl+E", [](Viewer& v) { v.ask_export(); }, has_light});
  add_line(items, "File");
  items.push_back({{"File", "Quit"}, "Ctrl+Q", [](Viewer& v) { v.close(); }});
}

void add_views(const Viewer& viewer, Items& items) {
  items.push_back({{"View", "Home view"}, "H", [](Viewer& v) { v.camera.home(); }});
  const auto count = viewer.file_views();
  if (count == 0) items.push_back({{"View", "Views of the file", "none"}, "", [](Viewer&) {}, false});
  for (std::size_t i = 0; i < count; ++i)
    items.push_back({{"View", "Views of the file", fmt::format("Camera {}", i + 1)}, "", [i](Viewer& v) {
                       v.go_to_file_view(i);
                     }});
  for (std::size_t i = 0; i < CameraController::views; ++i)
    items.push_back({{"View", "Saved views", fmt::format("View {}", i + 1)},
                     fmt::format("{}", i + 1),
                     [i](Viewer& v) { v.camera.recall_view(i); },
                     viewer.camera.has_view(i)});
  items.push_back({{"View", "Saved views", ""}});
  for (std::size_t i = 0; i < CameraController::views; ++i)
    items.push_back({{"View", "Saved views", fmt::format("Save as {}", i + 1)},
                     fmt::format("Ctrl+{}", i + 1),
                     [i](Viewer& v) { v.camera.save_view(i); }});
  items.push_back(
      {{"View", "Fly"}, "Tab", [](Viewer& v) { v.toggle_flying(); }, true, viewer.camera.is_flying()});
  add_line(items, "View");
}

void add_shown(const Look& look, Items& items) {
  for (int i = 0; i < show_count; ++i) {
    const auto each = static_cast<Show>(i);
    items.push_back({{"View", "Show", heading_of(each)},
                     "",
                     [each](Viewer& v) { v.look.show = each; },
                     true,
                     look.show == each});
  }
  constexpr std::array operators = {ToneOperator::neutral, ToneOperator::reinhard,
                                    ToneOperator::reinhard_local, ToneOperator::maximum, ToneOperator::clamp};
  for (const auto each : operators)
    items.push_back({{"View", "Tone", std::string(name(each))},
                     "",
                     [each](Viewer& v) { v.look.tone.op = each; },
                     true,
                     look.tone.op == each});
  items.push_back(
      {{"View", "False colours"},
       "I",
       [](Viewer& v) { v.look.show = v.look.show == Show::irradiance ? Show::light : Show::irradiance; },
       true,
       look.show == Show::irradiance});
  const std::pair<const char*, bool Look::*> overlays[] = {{"Patch edges", &Look::wires},
                                                           {"Normals", &Look::normals},
                                                           {"Boxes of the patch tree", &Look::boxes},
                                                           {"Rays of a patch", &Look::rays},
                                                           {"Rays to lamps", &Look::samples},
                                                           {"Faults", &Look::diagnostics},
                                                           {"Photometric solids", &Look::solids}};
  const char* keys[] = {"G", "N", "B", "R", "", "", "C"};
  for (std::size_t i = 0; i < std::size(overlays); ++i)
    add_switch(items, {"View", "Overlays", overlays[i].first}, keys[i], overlays[i].second, look);
}

void add_view_menu(const Viewer& viewer, Items& items) {
  const auto& look = viewer.look;
  add_views(viewer, items);
  add_shown(look, items);
  add_line(items, "View");
  add_switch(items, {"View", "Panels", "Panel and menus"}, "P", &Look::panel, look);
  add_switch(items, {"View", "Panels", "Line of keys"}, "", &Look::keys, look);
  items.push_back({{"View", "Full screen"},
                   "F11",
                   [](Viewer& v) { v.toggle_full_screen(); },
                   true,
                   viewer.is_full_screen()});
}

void add_lamps(const Viewer& viewer, Items& items) {
  const auto& mixer = viewer.light.mixer;
  const bool can_change = viewer.session.mesh() && viewer.session.status().can_relight;
  items.push_back(
      {{"Light", "Undo"}, "Ctrl+Z", [](Viewer& v) { v.undo_light(); }, viewer.light.history.can_undo()});
  items.push_back({{"Light", "Redo"},
                   "Ctrl+Shift+Z",
                   [](Viewer& v) { v.redo_light(); },
                   viewer.light.history.can_redo()});
  for (std::size_t i = 0; i < mixer.lamps.size(); ++i)
    items.push_back({{"Light", "Lamps", mixer.lamps[i].name},
                     "",
                     [i](Viewer& v) { v.switch_lamp(i); },
                     can_change,
                     mixer.lamps[i].factor > 0.0f});
  if (mixer.lamps.empty()) items.push_back({{"Light", "Lamps", "none"}, "", [](Viewer&) {}, false});
  items.push_back({{"Light", "As in the file"},
                   "",
                   [](Viewer& v) { v.reset_light(); },
                   can_change && !mixer.is_untouched()});
  add_line(items, "Light");
}

void add_light_menu(const Viewer& viewer, Items& items) {
  add_lamps(viewer, items);
  const auto& look = viewer.look;
  items.push_back({{"Light", "Exposure", "Brighter"}, "Page Up", [](Viewer& v) { v.change_exposure(1); }});
  items.push_back({{"Light", "Exposure", "Darker"}, "Page Down", [](Viewer& v) { v.change_exposure(-1); }});
  items.push_back({{"Light", "Exposure", "No correction"},
                   "",
                   [](Viewer& v) { v.look.tone.exposure = 0.0f; },
                   look.tone.exposure != 0.0f});
  add_switch(items, {"Light", "Exposure", "Follow what is in view"}, "X", &Look::automatic_exposure, look);
  add_line(items, "Light");
  const bool has_scene = viewer.session.has_scene();
  const bool is_solving = has_scene && !viewer.session.status().is_idle;
  const bool is_paused = has_scene && viewer.session.status().is_paused;
  items.push_back({{"Light", is_paused ? "Resume" : "Pause"},
                   "Space",
                   [](Viewer& v) { v.toggle_pause(); },
                   is_solving || is_paused});
  items.push_back({{"Light", "Stop"}, "", [](Viewer& v) { v.session->stop(); }, is_solving});
  for (const auto each : all_methods())
    items.push_back({{"Light", "Solve by", std::string(name(each))},
                     "",
                     [each](Viewer& v) { v.solve_by(each); },
                     has_scene,
                     has_scene && viewer.session.status().method == name(each)});
}

}  // namespace

std::vector<MenuItem> menu_items(const Viewer& viewer) {
  Items items;
  add_file_menu(viewer, items);
  add_view_menu(viewer, items);
  add_light_menu(viewer, items);
  add_switch(items, {"Help", "Keys"}, "F1", &Look::help, viewer.look);
  add_switch(items, {"Help", "About Luxel"}, "", &Look::about, viewer.look);
  return items;
}

}  // namespace luxel
