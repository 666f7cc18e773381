// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <fmt/format.h>

#include "luxel/export/html_text.h"
#include "luxel/export/number_text.h"
#include "luxel/export/report_sections.h"
#include "luxel/photometry/polar_svg.h"

namespace luxel {
namespace {

std::string lamp_text(const Photometry& photometry) {
  const auto* lamp = photometry.lamp();
  if (lamp == nullptr) return "";
  if (lamp->name.empty() && !(lamp->flux > 0.0)) return "";
  std::string text = fmt::format("{:g}", lamp->count);
  if (!lamp->name.empty()) text += " × " + lamp->name;
  if (lamp->flux > 0.0) text += fmt::format(", {:.0f} lm", lamp->flux);
  if (!lamp->colour.empty()) text += ", colour " + lamp->colour;
  if (!lamp->colour_rendering.empty()) text += ", colour rendering " + lamp->colour_rendering;
  return text;
}

std::string type_data(const LuminaireType& type) {
  const auto& p = *type.photometry;
  HtmlTable table({}, 2);
  table.add({"Count", fmt::format("{}", type.count)});
  table.add_if("Maker", html_escaped(p.maker));
  table.add_if("Catalogue number", html_escaped(p.catalogue));
  table.add({"Luminous flux", fmt::format("{:.0f} lm", type.flux())});
  table.add({"Power", type.watts() ? fmt::format("{:.4g} W", *type.watts()) : "not stated in the file"});
  if (type.watts()) table.add({"Efficacy", fmt::format("{:.1f} lm/W", type.flux() / *type.watts())});
  table.add({"Luminous opening", text_of(p.opening)});
  table.add_if("Lamps", html_escaped(lamp_text(p)));
  table.add({"Dimming", fmt::format("{:.0f} %", 100.0 * type.dimming)});
  table.add({"Maintenance factor", fmt::format("{:.2f}", type.maintenance)});
  table.add({"Photometric file", html_escaped(fmt::format("{} ({}{})", p.file, p.format,
                                                          p.absolute ? ", absolute photometry" : ""))});
  table.add_if("Test report", html_escaped(p.test_report));
  return table.html();
}

std::string totals(const LightingReport& report) {
  const auto& list = report.luminaires;
  HtmlTable table({}, 2);
  table.add({"Luminaires", fmt::format("{}", list.placed.size())});
  table.add({"Luminous flux of all", fmt::format("{:.0f} lm", list.flux)});
  table.add({"Installed power", list.watts ? fmt::format("{:.4g} W", *list.watts)
                                           : "not known: a photometric file does not state it"});
  if (const auto density = report.power_density())
    table.add({"Power per floor area", fmt::format("{:.2f} W/m²", *density)});
  if (const auto energy = report.energy())
    table.add(
        {"Energy, estimated (LENI)",
         fmt::format("{:.1f} kWh/m² per year: the installed power for {:g} h, without controls, stand-by and "
                     "emergency lighting",
                     *energy, report.hours)});
  if (const auto density = report.power_density_per_100_lx())
    table.add({"Per 100 lx of the working plane", ratio_text(*density) + " W/m²"});
  return table.html();
}

std::string ugr_cell(double ugr) { return std::isfinite(ugr) ? fmt::format("{:.1f}", ugr) : "–"; }

std::string ugr_table_html(const UgrTable& ugr) {
  std::vector<std::string> head = {"Room"};
  for (const auto* view : {"crosswise", "endwise"})
    for (const auto& reflectance : ugr_reflectances)
      head.push_back(name_of(reflectance) + (view == std::string("crosswise") ? "<br/>cross" : "<br/>end"));
  HtmlTable table(head, 1);
  for (std::size_t r = 0; r < ugr_rooms.size(); ++r) {
    std::vector<std::string> row = {fmt::format("{:g}H × {:g}H", ugr_rooms[r].across, ugr_rooms[r].along)};
    for (const auto* values : {&ugr.crosswise, &ugr.endwise})
      for (const auto value : (*values)[r]) row.push_back(ugr_cell(value));
    table.add(row);
  }
  return "<div class=\"dense\">" + table.html() + "</div>\n";
}

}  // namespace

std::string luminaire_section(const LightingReport& report) {
  const auto& list = report.luminaires;
  std::string html = "<div class=\"whole\"><h2>Luminaires</h2>\n";
  if (list.types.empty())
    html +=
        "<p>The solution has no luminaires with photometric files, so that there is no list of luminaires "
        "and "
        "no power.</p>\n";
  else
    html += totals(report);
  if (list.lamp_surfaces + list.other_lights > 0)
    html += fmt::format(
        "<p>The scene also has light without photometric files: surfaces that emit: {}; points, spots and "
        "suns: "
        "{}. Their power is not known and not counted.</p>\n",
        list.lamp_surfaces, list.other_lights);
  html += "</div>\n";
  for (std::size_t t = 0; t < list.types.size(); ++t)
    html += fmt::format(
        "<div class=\"whole\"><h3>Type {}: {}</h3>\n<div "
        "class=\"luminaire\"><div>{}</div><div>{}</div></div></div>\n",
        t + 1, html_escaped(list.types[t].name()), type_data(list.types[t]),
        polar_svg(*list.types[t].photometry));
  if (list.types.empty()) return html;
  return html +
         "<p class=\"note\">Luminous flux: initial, of one luminaire, by the zonal rule from the file's "
         "intensities. "
         "Power: of one luminaire as the file states it, not dimmed.</p>\n";
}

std::string ugr_table_section(const LightingReport& report) {
  std::string html;
  const auto& types = report.luminaires.types;
  for (std::size_t t = 0; t < types.size(); ++t) {
    html += fmt::format("<div class=\"whole\"><h3>Type {}: {}</h3>\n", t + 1, html_escaped(types[t].name()));
    html += types[t].ugr ? ugr_table_html(*types[t].ugr)
                         : "<p>There is no table: " + html_escaped(types[t].why_no_ugr) + ".</p>\n";
    html += "</div>\n";
  }
  if (html.empty()) return "";
  return "<h2>UGR tables of the luminaires</h2>\n"
         "<p class=\"note\">By CIE 190 for undimmed luminaires 2 m above the eye (H) at a distance of 0.25 "
         "H; "
         "reflectances of ceiling, walls and floor in per cent; the first side of a room is at right angles "
         "to "
         "the line of sight.</p>\n" +
         html;
}

}  // namespace luxel
