// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "luxel/export/lighting_report.h"

namespace luxel {

// Sections of the page, HTML.
std::string summary_section(const LightingReport& report);     // what matters, and verdicts
std::string room_section(const LightingReport& report);        // size and materials
std::string luminaire_section(const LightingReport& report);   // list, diagrams, power
std::string plan_section(const LightingReport& report);        // plan, and places
std::string plane_section(const LightingReport& report);       // figures, isolux lines, values
std::string surface_section(const LightingReport& report);     // illuminance of floor, walls, ceiling
std::string glare_section(const LightingReport& report);       // observers
std::string ugr_table_section(const LightingReport& report);   // of each type of luminaires
std::string assumption_section(const LightingReport& report);  // assumptions and limits
std::string origin_section(const LightingReport& report);      // program, seed, errors, commands

}  // namespace luxel
