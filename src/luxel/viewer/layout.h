// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <imgui.h>

namespace luxel {

// Lengths in heights of the text, which grow with it on displays whose pixels are small; in the cursor's
// units. Between Gui::begin() and Gui::draw().
inline float em(float heights) { return heights * ImGui::GetFontSize(); }

inline float panel_width() { return em(20.0f); }

// Flags of a panel without controls.
inline constexpr auto still_card = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoFocusOnAppearing |
                                   ImGuiWindowFlags_NoNav | ImGuiWindowFlags_AlwaysAutoResize;

}  // namespace luxel
