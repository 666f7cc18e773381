// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/report_page.h"

#include <fmt/format.h>

#include "luxel/export/html_text.h"
#include "luxel/export/page_parts.h"
#include "luxel/export/report_sections.h"

namespace luxel {
namespace {

std::string picture_of(const LightingReport& report) {
  if (report.picture.empty()) return "";
  return fmt::format(
      "<figure><img alt=\"View of the lit room\" src=\"data:image/png;base64,{}\"/>\n<figcaption>View of the "
      "lit "
      "room, computed from the solution.</figcaption></figure>\n",
      base64(report.picture));
}

}  // namespace

std::string report_page(const LightingReport& report) {
  auto html =
      page_begin(report.title, report.origin.version,
                 {{"Project", report.project}, {"Author", report.author}, {report.date_label, report.date}});
  html += summary_section(report) + picture_of(report) + room_section(report) + surface_section(report);
  html += plan_section(report) + luminaire_section(report) + plane_section(report) + glare_section(report);
  html += ugr_table_section(report);
  if (report.daylight) html += daylight_sections(*report.daylight);
  html += assumption_section(report) + origin_section(report);
  return html + "</body>\n</html>\n";
}

}  // namespace luxel
