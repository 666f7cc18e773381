// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace luxel {

class Viewer;

// One entry of a menu. The window draws them, and scripts choose them by their paths.
struct MenuItem {
  std::vector<std::string> path;             // menu, menus within it, and the entry's own name
  std::string keys = {};                     // that do the same
  std::function<void(Viewer&)> choose = {};  // empty: a line between entries
  bool is_enabled = true;
  std::optional<bool> is_checked = {};  // of a switch
};

// All entries as they are at this moment, in order; those of one menu follow each other.
std::vector<MenuItem> menu_items(const Viewer& viewer);

// The bar at the top, between Gui::begin() and Gui::draw(). Returns its height in the cursor's units; 0 where
// it is hidden: with the panel, until the cursor is at the top of the window.
float menu_bar(Viewer& viewer);

// Chooses the entry of this path, with slashes: "Light/Undo". Throws InputError, one sentence, where there is
// none, or it cannot be chosen now.
void choose_menu(Viewer& viewer, const std::string& path);

}  // namespace luxel
