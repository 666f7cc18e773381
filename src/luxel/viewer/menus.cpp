// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/menus.h"

#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui.h>

#include "luxel/core/error.h"
#include "luxel/viewer/viewer.h"

namespace luxel {
namespace {

void draw_item(Viewer& viewer, const MenuItem& item, const std::string& label) {
  if (!item.choose) return ImGui::Separator();
  if (ImGui::MenuItem(label.c_str(), item.keys.c_str(), item.is_checked.value_or(false), item.is_enabled))
    item.choose(viewer);
}

// Entries whose paths are the same up to this depth.
void draw_items(Viewer& viewer, std::span<const MenuItem> items, std::size_t depth) {
  for (std::size_t i = 0; i < items.size();) {
    const auto& path = items[i].path;
    if (path.size() == depth + 1) {
      draw_item(viewer, items[i++], path.back());
      continue;
    }
    const auto first = i;
    while (i < items.size() && items[i].path.size() > depth + 1 && items[i].path[depth] == path[depth]) ++i;
    if (!ImGui::BeginMenu(path[depth].c_str())) continue;
    draw_items(viewer, items.subspan(first, i - first), depth + 1);
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) ImGui::CloseCurrentPopup();
    ImGui::EndMenu();
  }
}

bool is_shown(const Viewer& viewer) {
  if (viewer.look.panel) return true;
  const auto& io = ImGui::GetIO();
  const bool is_at_top = io.MousePos.y >= 0.0f && io.MousePos.y < ImGui::GetFrameHeight();
  const bool is_in_use = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup) &&
                         viewer.notices.dialog() == nullptr && !viewer.file_dialog.is_open();
  return is_at_top || is_in_use;
}

}  // namespace

float menu_bar(Viewer& viewer) {
  if (!is_shown(viewer) || !ImGui::BeginMainMenuBar()) return 0.0f;
  const float height = ImGui::GetWindowSize().y;
  draw_items(viewer, menu_items(viewer), 0);
  ImGui::EndMainMenuBar();
  return height;
}

void choose_menu(Viewer& viewer, const std::string& path) {
  for (const auto& item : menu_items(viewer)) {
    if (!item.choose || fmt::format("{}", fmt::join(item.path, "/")) != path) continue;
    if (!item.is_enabled) throw InputError(fmt::format("the menu entry '{}' cannot be chosen now", path));
    return item.choose(viewer);
  }
  throw InputError(fmt::format("there is no menu entry '{}'", path));
}

}  // namespace luxel
