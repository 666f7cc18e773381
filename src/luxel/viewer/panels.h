// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/viewer/viewer.h"

namespace luxel {

// The parts of the window that are drawn over the scene, each declared between Gui::begin() and Gui::draw().

void panel(Viewer& viewer);           // all of the panel: the sections below
void solver_section(Viewer& viewer);  // stage, error, plot, pause, methods
void look_section(Viewer& viewer);    // what is shown, tone, exposure
void lamps_section(Viewer& viewer);   // light groups, surface colours
void overlays_section(Viewer& viewer);
void files_section(Viewer& viewer);
void views_section(Viewer& viewer);

void key_line(const Viewer& viewer);    // what the keys do, at the bottom, and what was reported last
void key_card(const Viewer& viewer);    // all keys, on request
void about_card(const Viewer& viewer);  // version and licence, on request
void legend(const Viewer& viewer);
void probe_card(const Viewer& viewer);
void profile_card(Viewer& viewer);
void dialogs(Viewer& viewer);

}  // namespace luxel
