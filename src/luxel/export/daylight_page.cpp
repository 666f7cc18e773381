// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/daylight_page.h"

#include <cmath>

#include <fmt/format.h>

#include "luxel/export/html_text.h"
#include "luxel/export/page_parts.h"
#include "luxel/lighting/daylight_plans.h"
#include "luxel/lighting/rating.h"

namespace luxel {
namespace {

std::string hours_text(const Figure& f) {
  auto text = fmt::format("{:.0f} h", f.value);
  return f.low < f.high ? text + fmt::format(" ({:.0f} to {:.0f})", f.low, f.high) : text;
}

// The value of a box, and its interval, which stands below it.
std::string box_of(const char* name, const Figure& fraction, int decimals, const char* what) {
  const auto text = per_cent_text(fraction, decimals);
  const auto bracket = text.find(" (");
  auto note = bracket == std::string::npos ? std::string()
                                           : text.substr(bracket + 2, text.size() - bracket - 3) + " %";
  if (*what != '\0') note += (note.empty() ? "" : "; ") + std::string(what);
  return page_box(name, text.substr(0, bracket), note);
}

std::string summary(const DaylightPage& page, const char* heading) {
  auto html = page_heading(heading) + "<div class=\"figures\">\n";
  const auto& f = page.factors.front();
  html += box_of("Mean daylight factor", f.mean, 2, "");
  html += box_of("Median daylight factor", f.median, 2, "");
  if (page.year) {
    const auto& m = page.year->metrics;
    html += box_of("Mean daylight autonomy, 300 lx", m.autonomy.mean, 1, "");
    html += box_of("sDA300,50%", m.autonomy_with_blinds, 0, "blinds operated");
    html += box_of("ASE1000,250h", m.sun_exposure, 0, "blinds open");
    html += box_of("Useful daylight, 100 to 3,000 lx", m.useful.mean, 1, "mean");
  }
  return html + fmt::format(
                    "</div>\n<p class=\"note\">{}. Below each number its 95 % interval, unless it has no "
                    "extent.</p>\n",
                    html_escaped(page.points_description));
}

class Requirements {
 public:
  void add(const std::string& what, const std::string& value, const std::string& needed,
           const std::string& verdict) {
    table_.add(
        {what == last_ ? "" : html_escaped(what), interval_cell(value), html_escaped(needed), verdict});
    last_ = what;
  }
  std::string html() const { return "<div class=\"verdicts\">" + table_.html() + "</div>\n"; }

 private:
  HtmlTable table_{{"Requirement", "Value (95 % interval)", "Needed", "Verdict"}, 4};
  std::string last_;
};

void add_factor_provision(const DaylightPage& page, Requirements& table) {
  for (const auto& p : page.provision) {
    const auto what = fmt::format("EN 17037 by daylight factor, {}", p.level);
    table.add(what, per_cent_text(p.on_target, 0),
              fmt::format("{:.2f} % on 50 % of the points", 100.0 * p.target_factor),
              compliance_span(compliance_of(p.verdict)));
    table.add(what, per_cent_text(p.on_minimum, 0), fmt::format("{:.2f} % on 95 %", 100.0 * p.minimum_factor),
              "");
  }
}

void add_climate_provision(const YearReport& year, Requirements& table) {
  for (const auto& p : year.provision) {
    const auto what = fmt::format("EN 17037 on the climate, {}, by points", p.level);
    table.add(what, per_cent_text(p.points_on_target, 0),
              fmt::format("{:.0f} lx in half of the hours on 50 % of the points", p.target),
              compliance_span(compliance_by_points(p)));
    table.add(what, per_cent_text(p.points_on_minimum, 0), fmt::format("{:.0f} lx on 95 %", p.minimum), "");
  }
  for (const auto& p : year.provision) {
    const auto what = fmt::format("EN 17037 on the climate, {}, by hours", p.level);
    table.add(what, per_cent_text(p.hours_on_target, 0),
              fmt::format("{:.0f} lx on half of the points in 50 % of the hours", p.target),
              compliance_span(compliance_by_hours(p)));
    table.add(what, per_cent_text(p.hours_on_minimum, 0),
              fmt::format("{:.0f} lx on 95 % of the points in 50 %", p.minimum), "");
  }
}

void add_ratings(const YearReport& year, Requirements& table) {
  const auto& m = year.metrics;
  const auto low = leed_points(m.autonomy_with_blinds.low), high = leed_points(m.autonomy_with_blinds.high);
  auto points = fmt::format(
      "<span class=\"verdict {}\">{}{}</span>", low == high ? "met" : "open",
      low == high ? fmt::format("{} of 3 points", low) : fmt::format("{} to {} of 3 points", low, high),
      low == high ? "" : ", cannot be told yet");
  if (high == 0) points = compliance_span(Compliance::not_met);
  table.add("LEED v4.1, option 1: sDA300,50%", per_cent_text(m.autonomy_with_blinds, 0),
            "40, 55, 75 % for 1, 2, 3 points", points);
  const auto exposure = leed_exposure_compliance(m.sun_exposure);
  table.add("LEED v4.1, option 1: ASE1000,250h", per_cent_text(m.sun_exposure, 0), "at most 10 %",
            exposure == Compliance::not_met ? "<span class=\"verdict open\">explanation needed</span>"
                                            : compliance_span(exposure));
  table.add("BREEAM: 300 lx in the mean", hours_text(year.hours_mean_300),
            fmt::format("{:.0f} h per year", breeam_hours), compliance_span(breeam_compliance(year)));
  table.add("BREEAM: 90 lx at the darkest point", hours_text(year.hours_min_90),
            fmt::format("{:.0f} h per year", breeam_hours), "");
}

std::string verdicts(const DaylightPage& page, const char* heading) {
  auto html = page_heading(heading);
  if (page.provision.empty())
    return html +
           "<p>None: EN 17037 needs a weather file or the median diffuse illuminance of the place.</p>\n";
  Requirements table;
  add_factor_provision(page, table);
  if (page.year) {
    add_climate_provision(*page.year, table);
    add_ratings(*page.year, table);
  }
  html += table.html();
  html += fmt::format(
      "<p class=\"note\">Median diffuse illuminance outside: {} lx. EN 17037 on the climate is read in "
      "two "
      "ways, since tools differ: the fraction of points that have the illuminance in half of the hours, and "
      "the fraction of hours in which enough points have it.</p>\n",
      scale_number(page.median_diffuse));
  return html +
         "<p><b>Not assessed:</b> glare by daylight, view out, and exposure to sunlight on a day. There is "
         "no "
         "verdict on EN 17037, LEED or BREEAM as a whole.</p>\n";
}

std::string plans(const DaylightPage& page, const char* heading) {
  if (page.plans.empty()) return "";
  auto html = page_heading(heading) +
              fmt::format("<div class=\"{}\">\n", page.are_plans_wide ? "wide-plans" : "plans");
  for (const auto& plan : page.plans) html += "<figure>\n" + plan + "</figure>\n";
  return html + "</div>\n";
}

std::string heat_map(const DaylightPage& page, const char* heading) {
  if (page.heat_map.empty()) return "";
  return page_heading(heading) +
         page_figure(page.heat_map, "Illuminance hour by hour; black is night. Blinds open.");
}

std::string components(const DaylightPage& page) {
  const auto mean = [&](DaylightPath path) {
    double sum = 0.0;
    const auto& part = page.factors.front().components[static_cast<std::size_t>(path)];
    for (const auto v : part) sum += static_cast<double>(v);
    return 100.0 * sum / static_cast<double>(part.size());
  };
  const auto external = mean(DaylightPath::external), internal = mean(DaylightPath::internal);
  auto text = fmt::format("sky component {:.2f} %, ", mean(DaylightPath::sky));
  text += page.knows_openings ? fmt::format("externally reflected {:.2f} %, internally reflected {:.2f} %",
                                            external, internal)
                              : fmt::format("reflected {:.2f} %", external + internal);
  return text;
}

std::string figures(const DaylightPage& page, const char* heading) {
  HtmlTable table({"Quantity", "Value (95 % interval)"}, 2);
  const auto add = [&](const std::string& name, const std::string& value) {
    table.add({html_escaped(name), interval_cell(value)});
  };
  for (const auto& f : page.factors) {
    const auto sky = fmt::format(" daylight factor, CIE sky type {}", f.cie_type);
    add("Mean" + sky, per_cent_text(f.mean, 2));
    add("Median" + sky, per_cent_text(f.median, 2));
    add("Minimum" + sky, per_cent_text(f.min, 2));
    add(fmt::format("Uniformity (minimum over mean), type {}", f.cie_type),
        fmt::format("{:.2f} ({:.2f} to {:.2f})", f.min_over_mean.value, f.min_over_mean.low,
                    f.min_over_mean.high));
  }
  add(fmt::format("Parts of the mean, type {}", page.factors.front().cie_type), components(page));
  if (page.year) {
    const auto& m = page.year->metrics;
    add("Daylight autonomy, 300 lx, mean over the points", per_cent_text(m.autonomy.mean, 1));
    add("Continuous daylight autonomy, 300 lx, mean", per_cent_text(m.continuous_autonomy.mean, 1));
    add("Below 100 lx, mean", per_cent_text(m.below_100.mean, 1));
    add("Useful daylight, 100 to 3,000 lx, mean", per_cent_text(m.useful.mean, 1));
    add("Autonomous, 300 to 3,000 lx, mean", per_cent_text(m.autonomous.mean, 1));
    add("Above 3,000 lx, mean", per_cent_text(m.above_3000.mean, 1));
    add("sDA300,50%, blinds operated", per_cent_text(m.autonomy_with_blinds, 0));
    add("sDA300,50%, blinds always open", per_cent_text(m.autonomy_of_space, 0));
    add("Points too near to 50 % autonomy to tell", fmt::format("{:.0f} %", 100.0 * m.too_near_to_tell));
    add("ASE1000,250h", per_cent_text(m.sun_exposure, 0));
    add("Points too near to 250 h of sun to tell", fmt::format("{:.0f} %", 100.0 * m.sun_too_near_to_tell));
    add("Hours with closed blinds", fmt::format("{} h", m.hours_with_blinds));
    if (page.metrics.lighting.power > 0.0) {
      const auto energy = [](const Figure& f) {
        return fmt::format("{:.0f} kWh per year ({:.0f} to {:.0f})", f.value, f.low, f.high);
      };
      add("Energy of dimmed lamps", energy(m.lighting_energy));
      add("Saved by dimming", energy(m.lighting_saved));
    }
    add("Annual light exposure, mean",
        fmt::format("{} klx h ({} to {})", scale_number(std::round(1e-3 * m.exposure.mean.value)),
                    scale_number(std::round(1e-3 * m.exposure.mean.low)),
                    scale_number(std::round(1e-3 * m.exposure.mean.high))));
  }
  return "<div class=\"whole\">" + page_heading(heading) + table.html() + "</div>\n";
}

std::string blinds_text(const DaylightPage& page) {
  const auto& o = page.metrics;
  const auto& groups = page.year->metrics.blinds;
  std::string text = "Blinds: ";
  for (const auto& group : groups)
    text += fmt::format("{}{} ({:g} % of light let through when closed, closed {:.0f} h)",
                        &group == &groups.front() ? "" : ", ", group.name, 100.0 * group.transmittance,
                        group.closed_hours);
  text += o.schedule.closed.empty()
              ? fmt::format(
                    ". A group closes in occupied hours in which more than {:g} % of the points have more "
                    "than {:g} lx straight from the sun through it.",
                    100.0 * o.blinds.part, o.blinds.limit)
              : ". They follow the schedule.";
  if (page.year->light_taken_twice != 0.0)
    text += fmt::format(
        " Light that crosses windows of two groups is taken away twice where both are closed: {:.2g} % "
        "of all light.",
        100.0 * page.year->light_taken_twice);
  return text + " Only sDA with operated blinds and the energy of dimmed lamps have blinds.";
}

std::string assumptions(const DaylightPage& page, const char* heading) {
  std::string html = "<div class=\"whole\">" + page_heading(heading) + "<ul>\n";
  const auto item = [&](const std::string& text) { html += "<li>" + html_escaped(text) + "</li>\n"; };
  item(
      "Daylight factor: the illuminance over that of unobstructed ground under an overcast sky without sun; "
      "CIE sky type 16 is the traditional overcast sky, type 1 the standard overcast sky.");
  item(fmt::format(
      "Ground outside: diffuse reflectance {:g}. North: {:g} degrees clockwise seen from above, from "
      "+Y where Z is up, from -Z where Y is up.",
      page.albedo, page.north));
  if (page.year) {
    const auto& o = page.metrics;
    item(fmt::format(
        "Sky of each hour: Perez's all-weather model by the irradiances of the weather file, in {} patches. "
        "Light straight from the sun comes from its place in the middle of the hour, a disc of 0.53 degrees; "
        "reflected sunlight is as coarse as the patches.",
        page.sky_patches));
    item(fmt::format(
        "Occupied hours: {}, {} h. For EN 17037 on the climate: the {} hours with the most diffuse light.",
        o.schedule.occupied.empty()
            ? fmt::format("{:g} to {:g} h of local standard time on all days", o.from, o.to)
            : "those of the schedule",
        page.year->metrics.occupied_hours, page.year->daylight_hours));
    item(blinds_text(page));
  }
  for (const auto& note : page.notes) item(note.ends_with('.') ? note : note + ".");
  item("All surfaces reflect diffusely. The room has the furniture that the scene has, and no other.");
  item(
      "Intervals contain the true value of this model with a probability of 95 %; they come from independent "
      "replicates of all rays. They do not contain the tolerances of reflectances, glass and weather, the "
      "size of the patches of sky and surfaces, and places between the points.");
  item(
      "Verdicts: met, if the whole interval meets the requirement; not met, if none of it does; cannot be "
      "told yet, if the requirement is within the interval: a solve with a smaller error decides.");
  return html + "</ul>\n</div>\n";
}

std::string origin(const DaylightPage& page) {
  HtmlTable table({}, 2);
  table.add({"Computed with", html_escaped(fmt::format("Luxel {}, seed {}", page.version, page.seed))});
  table.add(
      {"Error of the light", fmt::format("{:.2g} % of the light of the mean sky", 100.0 * page.solve_error)});
  table.add({"Command", "<code>" + html_escaped(page.command) + "</code>"});
  return "<div class=\"whole\">" + page_heading("Origin") + table.html() + "</div>\n";
}

}  // namespace

std::string daylight_sections(const DaylightPage& page) {
  return "<section class=\"daylight\">\n" + summary(page, "Daylight") +
         verdicts(page, "Daylight: requirements") + plans(page, "Daylight: plans") +
         heat_map(page, "Daylight: the year") + figures(page, "Daylight: figures") +
         assumptions(page, "Daylight: assumptions and limits") + "</section>\n";
}

std::string daylight_page(const DaylightPage& page) {
  auto html = page_begin(page.title, page.version,
                         {{"Scene", page.scene},
                          {"Scene file dated", page.scene_date},
                          {"Place", page.place},
                          {"Weather", page.weather}});
  html += summary(page, "Summary") + verdicts(page, "Requirements") + plans(page, "Plans") +
          heat_map(page, "The year") + figures(page, "Figures");
  html += page_heading("Room") + room_tables(page.room) + assumptions(page, "Assumptions and limits") +
          origin(page);
  return html + "</body>\n</html>\n";
}

}  // namespace luxel
