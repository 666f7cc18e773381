// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "luxel/export/html_text.h"
#include "luxel/export/report_sections.h"

namespace luxel {
namespace {

const char* errors_text(SolutionErrors errors) {
  switch (errors) {
    case SolutionErrors::replicates:
      return "The error of the solution comes from the spread of its stored replicates.";
    case SolutionErrors::patches:
      return "The error of the solution is an upper bound from the standard errors of its patches; a "
             "solution with stored transport has narrower intervals.";
    case SolutionErrors::not_stated:
      break;
  }
  return "The method of the solution states no errors, so that the intervals contain the errors of "
         "measurement alone.";
}

std::string maintenance_text(const LightingReport& report) {
  const auto& m = report.maintenance;
  if (m.is_initial())
    return "Maintenance factor 1: the illuminances are those of new luminaires in a clean room.";
  std::string text = "Maintained illuminances: ";
  if (!m.luminaires.is_initial())
    text += "the light of each luminaire contains its " + AppliedMaintenance{m.luminaires, {}}.text() + "; ";
  if (m.area.factor < 1.0)
    text +=
        "the light on planes and surfaces is multiplied by the maintenance factor " + text_of(m.area) + "; ";
  return text +
         "areas may have factors of their own. The initial illuminance is the maintained one over the "
         "factor.";
}

}  // namespace

std::string assumption_section(const LightingReport& report) {
  std::string html = "<div class=\"whole\"><h2>Assumptions and limits</h2>\n<ul>\n";
  const auto item = [&](const std::string& text) { html += "<li>" + text + "</li>\n"; };
  item(
      "Intervals contain the true value of this model with a probability of at least 95 %. They contain the "
      "errors of the sampled light and of the rays that measure it.");
  item(errors_text(report.origin.errors));
  item(
      "They do not contain: the tolerance of luminaires, of their photometric files and of reflectances; the "
      "size "
      "of the patches of the solution; and, for minimum and maximum, places between the points of the grid.");
  item(maintenance_text(report));
  item("All surfaces reflect diffusely, with the reflectances of the table of materials.");
  item("The room has the furniture and the people that the scene has, and no others.");
  item(
      "Verdicts: <b>met</b>, if the whole interval meets the requirement; <b>not met</b>, if none of it "
      "does; "
      "<b>cannot be told yet</b>, if the requirement is within the interval; <b>not known</b>, if the data "
      "for "
      "it are missing.");
  return html + "</ul>\n</div>\n";
}

std::string origin_section(const LightingReport& report) {
  const auto& o = report.origin;
  HtmlTable table({}, 2);
  table.add({"Solution", html_escaped(o.solution)});
  table.add({"Method", html_escaped(fmt::format("{}, {} patches, {} rays, seed {}", o.method, o.patches,
                                                o.rays, o.seed))});
  if (o.seen_error > 0.0)
    table.add(
        {"Seen error of the solution",
         fmt::format("{:.2g} %: 95 % of views have at most this standard error", 100.0 * o.seen_error)});
  table.add_if("Solved with", html_escaped("Luxel " + o.solution_version));
  if (!o.solution_command.empty())
    table.add({"Command of the solution", "<code>" + html_escaped(o.solution_command) + "</code>"});
  table.add({"Measured with", html_escaped(fmt::format("Luxel {}, seed {}", o.version, o.measuring_seed))});
  table.add({"Command of this report", "<code>" + html_escaped(o.report_command) + "</code>"});
  return "<div class=\"whole\"><h2>Origin</h2>\n" + table.html() + "</div>\n";
}

}  // namespace luxel
