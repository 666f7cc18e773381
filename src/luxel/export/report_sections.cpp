// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/report_sections.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "luxel/export/html_text.h"
#include "luxel/export/number_text.h"
#include "luxel/export/page_parts.h"

namespace luxel {
namespace {

std::string interval_note(const Figure& number, std::string (*text)(double, int), const char* unit) {
  const auto interval = interval_text(number, text);
  return interval.empty() ? interval : interval + unit;
}

std::string verdict_cell(const Verdict& verdict) {
  auto cell = compliance_span(verdict.compliance);
  for (const auto& more : {verdict.note, remedy_of(verdict)})
    if (!more.empty()) cell += "<span class=\"more\">" + html_escaped(more) + "</span>";
  return cell;
}

// Verdicts with the name of what they judge, which stands once.
class VerdictTable {
 public:
  VerdictTable()
      : table_({"Area", "Required", "Value", "95 % interval", "Verdict"}, {false, false, true, true, false}) {
  }
  void add(const std::string& area, const Verdict& verdict) {
    table_.add({area == last_ ? "" : html_escaped(area), html_escaped(requirement_text(verdict)),
                html_escaped(measured_text(verdict)), html_escaped(interval_text(verdict)),
                verdict_cell(verdict)});
    last_ = area;
    is_empty_ = false;
  }
  std::string html() const {
    return is_empty_ ? "" : "<div class=\"verdicts\">" + table_.html() + "</div>\n";
  }

 private:
  HtmlTable table_;
  std::string last_;
  bool is_empty_ = true;
};

std::string all_verdicts(const LightingReport& report) {
  VerdictTable table;
  for (const auto& plane : report.planes) {
    for (const auto& verdict : plane.result.verdicts) table.add(plane.result.area.name, verdict);
    if (&plane == &report.planes[0] && report.ugr_verdict)
      table.add(plane.result.area.name, *report.ugr_verdict);
  }
  return table.html();
}

double largest_source(const ObservedGlare& glare) {
  double sum = 0.0;
  for (const auto& source : glare.sources) sum += source.glare();
  return sum > 0.0 ? glare.sources[0].glare() / sum : 0.0;
}

// m of its first corner above the floor.
double height_of(const LightingReport& report, const PlaneResult& plane) {
  const auto height = report.room.axes.in_plan(plane.grid.corner).z - report.room.low.z;
  return std::round(1000.0 * height) / 1000.0;  // mm
}

std::string grid_text(const LightingReport& report, const PlaneResult& plane) {
  const auto& grid = plane.grid;
  const bool is_level = std::abs(glm::dot(grid.normal, report.room.axes.up)) > 0.999;
  std::string text = is_level ? fmt::format("Level, {:g} m above the floor; ", height_of(report, plane)) : "";
  text += fmt::format("{} × {} points{}", grid.columns, grid.rows, grid.is_by_rule ? " by EN 12464-1" : "");
  if (plane.area.border > 0.0)
    text += fmt::format("; a strip of {:g} m along the edges is left out", plane.area.border);
  text += fmt::format("; {} points count", grid.points());
  if (plane.behind > 0) text += fmt::format("; {} inside or behind something do not", plane.behind);
  text += "; " + plane.maintenance().text() + (plane.maintenance().is_initial() ? " light" : "");
  if (grid.facing)
    text +=
        fmt::format("; points face {:.4g}, {:.4g}, {:.4g}", grid.facing->x, grid.facing->y, grid.facing->z);
  if (plane.area.is_direct) text += "; direct light only";
  if (!plane.area.requirement.source.empty() && !plane.verdicts.empty())
    text +=
        "; requirements: " + (plane.area.requirement.name.empty() ? "" : plane.area.requirement.name + ", ") +
        plane.area.requirement.source;
  return text + ".";
}

Figure scaled(const Figure& f, double factor) { return {factor * f.value, factor * f.low, factor * f.high}; }

// The figures of a plane beside what is required of them.
class PlaneTable {
 public:
  explicit PlaneTable(std::vector<Verdict> verdicts)
      : verdicts_(std::move(verdicts)),
        table_({"Quantity", "Value", "95 % interval", "Required", "Verdict"},
               {false, true, true, true, false}) {}

  // key: the quantity of its verdicts.
  void add(const char* name, const std::string& key, const Figure& n, std::string (*text)(double, int),
           const char* unit) {
    std::string required, cell;
    for (auto& v : verdicts_)
      if (!key.empty() && v.quantity == key) {
        required += (required.empty() ? "" : "<br/>") + limit_of(v);
        cell += verdict_cell(v);
        v.quantity.clear();
      }
    table_.add({name, text(n.value, 0) + unit, interval_note(n, text, unit), required, cell});
  }

  // With those verdicts that no figure of the plane has.
  std::string html() {
    for (const auto& v : verdicts_)
      if (!v.quantity.empty())
        table_.add({v.quantity == "Ra" ? "Colour rendering Ra" : html_escaped(v.quantity),
                    html_escaped(measured_text(v)), html_escaped(interval_text(v)), limit_of(v),
                    verdict_cell(v)});
    return "<div class=\"verdicts\">" + table_.html() + "</div>\n";
  }

 private:
  static std::string limit_of(const Verdict& v) {
    return fmt::format("{} {:.4g}{}", v.is_at_least ? "≥" : "≤", v.required,
                       v.quantity.starts_with("E") ? " lx" : "");
  }

  std::vector<Verdict> verdicts_;
  HtmlTable table_;
};

constexpr std::size_t max_values_on_a_line = 20;

std::string one_plane(const LightingReport& report, const ReportPlane& plane) {
  const auto& result = plane.result;
  PlaneTable table(result.verdicts);
  table.add("Mean illuminance Em", "Em", result.mean, lux_text, " lx");
  if (const auto factor = result.maintenance().factor(); factor && *factor < 1.0)
    table.add("Initial mean illuminance, new and clean", "", scaled(result.mean, 1.0 / *factor), lux_text,
              " lx");
  table.add("Minimum Emin", "Emin", result.min, lux_text, " lx");
  table.add("Maximum Emax", "", result.max, lux_text, " lx");
  table.add("Uniformity U0 = Emin / Em", "U0", result.min_over_mean, ratio_text, "");
  table.add("Uniformity Ud = Emin / Emax", "Ud", result.min_over_max, ratio_text, "");
  if (result.area.requirement.max_over_min)
    table.add("Emax / Emin", "max_over_min", result.max_over_min, ratio_text, "");
  if (result.cylindrical) table.add("Cylindrical illuminance Ez", "Ez", *result.cylindrical, lux_text, " lx");
  if (result.modelling) table.add("Modelling Ez / Em", "modelling", *result.modelling, ratio_text, "");
  auto html =
      "<section class=\"plane\">\n" + page_heading("Calculation plane: " + html_escaped(result.area.name));
  html += "<p>" + html_escaped(grid_text(report, result)) + "</p>\n" + table.html();
  const bool is_line = !(result.grid.height > 0.0);
  if (has_isolux_lines(result, plane.drawing))
    html += page_figure(isolux_svg(result, plane.drawing),
                        is_line ? "Illuminance along the line."
                        : plane.drawing.finer_values.empty()
                            ? "Isolux lines, lx; between the points interpolated."
                            : "Isolux lines, lx, from points three times as close.");
  if (!is_line || result.grid.points() <= max_values_on_a_line)
    html +=
        page_figure(value_grid_svg(result, plane.drawing), "Values at the points, lx, with false colours.");
  return html + "</section>\n";
}

// Illuminance of a surface with the maintenance factor of the working plane.
Figure scaled(const MeasuredNumber& n, const LightingReport& report) {
  return scaled(figure_of(n), report.maintenance.area.factor);
}

}  // namespace

std::string summary_section(const LightingReport& report) {
  const auto& plane = report.planes[0].result;
  std::string html = page_heading("Summary") + "<div class=\"figures\">\n";
  html += page_box("Mean illuminance Em", lux_text(plane.mean.value) + " lx",
                   interval_note(plane.mean, lux_text, " lx"));
  html += page_box("Uniformity U0", ratio_text(plane.min_over_mean.value),
                   interval_note(plane.min_over_mean, ratio_text, ""));
  if (const auto most = report.max_glare())
    html += page_box("Highest UGR", ugr_text(report.observers[*most].glare.ugr),
                     interval_note(report.observers[*most].ugr(), ugr_text, ""));
  if (const auto density = report.power_density())
    html += page_box("Installed power", fmt::format("{:.4g} W", *report.luminaires.watts),
                     fmt::format("{:.2f} W/m²", *density));
  html += fmt::format(
      "</div>\n<p class=\"note\">Values on the {}, {:g} m above the floor, {}; below each number its 95 % "
      "interval.</p>\n",
      html_escaped(plane.area.name), height_of(report, plane), plane.maintenance().text());
  html += all_verdicts(report);
  for (const auto& warning : report.warnings) html += "<p>" + html_escaped(warning) + "</p>\n";
  return html;
}

std::string room_section(const LightingReport& report) {
  return page_heading("Room") + room_tables(report.room);
}

std::string plan_section(const LightingReport& report) {
  std::vector<PlanObserver> observers;
  for (const auto& observer : report.observers) observers.push_back(observer.place);
  const bool has_luminaires = !report.luminaires.placed.empty();
  auto html = page_heading("Plan");
  html = "<div class=\"whole\">" + html;
  html +=
      page_figure(plan_svg(report.room, report.luminaires, observers),
                  fmt::format("Outline of the floor{}{}.",
                              has_luminaires ? ", luminaires to scale with their numbers" : "",
                              observers.empty() ? "" : ", observers of glare with the directions of view")) +
      "</div>\n";
  constexpr std::size_t max_rows = 60;  // of the table of places
  const auto& placed = report.luminaires.placed;
  if (placed.empty()) return html;
  if (placed.size() > max_rows)
    return html +
           fmt::format("<p class=\"note\">The places of the {} luminaires are in the JSON output.</p>\n",
                       placed.size());
  HtmlTable table({"No.", "Type", "x, m", "y, m", "z, m", "Turned, °"}, 0);
  const auto [low, floor] = std::pair(report.room.low, report.room.low.z);
  for (std::size_t i = 0; i < placed.size(); ++i)
    table.add({fmt::format("{}", i + 1), fmt::format("{}", placed[i].type + 1),
               fmt::format("{:.2f}", placed[i].position.x - low.x),
               fmt::format("{:.2f}", placed[i].position.y - low.y),
               fmt::format("{:.2f}", placed[i].position.z - floor),
               fmt::format("{:.0f}", placed[i].turn + 0.0)});
  return html + "<div class=\"dense narrow whole\">" + table.html() +
         "</div>\n<p class=\"note\">x to the right and y upwards from the lower left corner of the plan, z "
         "from the floor; "
         "anticlockwise turn of the luminaire's own X axis.</p>\n";
}

std::string plane_section(const LightingReport& report) {
  std::string html;
  for (const auto& plane : report.planes) html += one_plane(report, plane);
  return html;
}

std::string surface_section(const LightingReport& report) {
  HtmlTable table({"Surface", "Mean, lx", "Min, lx", "Max, lx", "Min / mean"}, 1);
  for (const auto& [name, m] : report.surfaces)
    table.add({html_escaped(name) + fmt::format(" <span class=\"i\">{:.2f} m²</span>", m.area),
               interval_cell(lux_text(scaled(m.mean, report))),
               interval_cell(lux_text(scaled(m.min, report))), interval_cell(lux_text(scaled(m.max, report))),
               interval_cell(ratio_text(figure_of(m.min_over_mean)))});
  if (report.surfaces.empty()) return "";
  auto html = "<div class=\"whole\">" + page_heading("Illuminance of the surfaces") + table.html() +
              "<p class=\"note\">Means over the patches of the solution, " + report.maintenance.text() +
              "; in brackets 95 % intervals.</p>\n</div>\n";
  if (report.unfolded.empty()) return html;
  return html + page_figure(
                    unfolded_svg(report.unfolded, report.room),
                    "The room unfolded: the floor as in the plan, the walls laid down around it, the ceiling "
                    "above; isolux lines and mean illuminances, lx.");
}

std::string glare_section(const LightingReport& report) {
  if (report.observers.empty()) return "";
  HtmlTable table({"Observer", "Place", "UGR", "Background, cd/m²", "Largest source"}, 2);
  for (const auto& o : report.observers) {
    const auto& g = o.glare;
    table.add({o.place.name, html_escaped(o.description), interval_cell(ugr_text(o.ugr())),
               fmt::format("{:.1f}", g.background),
               g.sources.empty() ? "none"
                                 : fmt::format("{} ({:.0f} %)", html_escaped(g.sources[0].name),
                                               100.0 * largest_source(g))});
  }
  const auto above = report.observers[0].place.eye.z - report.room.low.z;
  VerdictTable verdicts;
  if (report.ugr_verdict) verdicts.add(report.planes[0].result.area.name, *report.ugr_verdict);
  return "<div class=\"whole\">" + page_heading("Glare of observers") + table.html() + verdicts.html() +
         fmt::format(
             "<p class=\"note\">UGR by CIE 117, with the light of the solution ({}); observers A to D look "
             "level, "
             "their eyes {:g} m above the floor; in brackets 95 % intervals. A dash: no luminaire "
             "dazzles.</p>\n</div>\n",
             AppliedMaintenance{report.maintenance.luminaires, {}}.text(), above);
}

}  // namespace luxel
