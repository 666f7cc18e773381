// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "luxel/export/lighting_report.h"

namespace luxel {

// The report as one HTML page, which is also well-formed XML: for A4 paper, screens and phones, without
// scripts and without anything from outside. Texts of files are escaped. The same report gives the same
// bytes.
std::string report_page(const LightingReport& report);

}  // namespace luxel
