// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/daylight_report.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "luxel/cli/verdict_json.h"
#include "luxel/lighting/rating.h"

namespace luxel {
namespace {

using Json = nlohmann::ordered_json;

std::string per_cent(const Figure& f, int digits = 0) {
  return fmt::format("{:.{}f} % ({:.{}f} to {:.{}f})", 100.0 * f.value, digits, 100.0 * std::max(0.0, f.low),
                     digits, 100.0 * f.high, digits);
}
std::string part_of(const Figure& f) {
  return fmt::format("{:.0f} % ({:.0f} to {:.0f})", 100.0 * f.value, 100.0 * std::clamp(f.low, 0.0, 1.0),
                     100.0 * std::clamp(f.high, 0.0, 1.0));
}

const char* name(FactorProvision::Verdict verdict) {
  using V = FactorProvision::Verdict;
  return verdict == V::met ? "met" : verdict == V::not_met ? "not met" : "cannot be told";
}

std::string text_of(const DaylightFactors& f) {
  return fmt::format("daylight factor, CIE type {}: mean {}, median {}, minimum {}, uniformity {:.2f}\n",
                     f.cie_type, per_cent(f.mean, 2), per_cent(f.median, 2), per_cent(f.min, 2),
                     f.min_over_mean.value);
}

double mean_of(const std::vector<float>& values) {
  double sum = 0.0;
  for (const auto v : values) sum += static_cast<double>(v);
  return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

std::string components_text(const DaylightReport& report) {
  const auto& f = report.factors.front();
  const auto part = [&](DaylightPath path) {
    return 100.0 * mean_of(f.components[static_cast<std::size_t>(path)]);
  };
  if (!report.knows_openings)
    return fmt::format("of its mean, {:.2f} % come straight from the sky, {:.2f} % from surfaces\n",
                       part(DaylightPath::sky), part(DaylightPath::external) + part(DaylightPath::internal));
  return fmt::format(
      "of its mean, {:.2f} % are the sky component, {:.2f} % externally reflected, {:.2f} % "
      "internally reflected\n",
      part(DaylightPath::sky), part(DaylightPath::external), part(DaylightPath::internal));
}

std::string text_of(const FactorProvision& p) {
  return fmt::format(
      "EN 17037 by daylight factor, {}: {}: {:.2f} % on {} of the points (50 needed), {:.2f} % on "
      "{} (95 needed)\n",
      p.level, name(p.verdict), 100.0 * p.target_factor, part_of(p.on_target), 100.0 * p.minimum_factor,
      part_of(p.on_minimum));
}

std::string met(bool is_met, bool is_sure) {
  return is_met    ? is_sure ? "met" : "met, too near to tell"
         : is_sure ? "not met"
                   : "not met, too near to tell";
}

std::string text_of(const ClimateProvision& p) {
  return fmt::format(
      "EN 17037 on the climate, {}: by points {}: {:.0f} lx on {}, {:.0f} lx on {}; by hours {}: in {} and "
      "{} of "
      "the hours\n",
      p.level, met(p.met_by_points, p.sure_by_points), p.target, part_of(p.points_on_target), p.minimum,
      part_of(p.points_on_minimum), met(p.met_by_hours, p.sure_by_hours), part_of(p.hours_on_target),
      part_of(p.hours_on_minimum));
}

// A line on the groups of windows; empty where there is one group.
std::string blinds_text(const YearReport& year) {
  const auto& groups = year.metrics.blinds;
  if (groups.size() < 2) return {};
  std::string text = "blinds";
  for (const auto& group : groups)
    text += fmt::format("{} {} closed {:.0f} h, {:.0f} % of the light", &group == &groups.front() ? ":" : ";",
                        group.name, group.closed_hours, 100.0 * group.part_of_light);
  return text + fmt::format("; light through two of them {:.2f} %\n", 100.0 * year.light_taken_twice);
}

std::string text_of(const YearReport& year) {
  const auto& m = year.metrics;
  auto text = fmt::format(
      "a year at {} occupied hours: daylight autonomy (300 lx) {} in the mean over the points, useful "
      "daylight (100 to 3,000 lx) {}\n",
      m.occupied_hours, per_cent(m.autonomy.mean, 1), per_cent(m.useful.mean, 1));
  text += fmt::format(
      "sDA300,50% {} with blinds operated ({} hours closed), {} without; {:.0f} % of the points "
      "are too near to tell\n",
      part_of(m.autonomy_with_blinds), m.hours_with_blinds, part_of(m.autonomy_of_space),
      100.0 * m.too_near_to_tell);
  text += blinds_text(year);
  if (m.lighting_energy.value + m.lighting_saved.value > 0.0)
    text += fmt::format(
        "dimmed lamps take {:.0f} kWh ({:.0f} to {:.0f}); dimming saves {:.0f} kWh ({:.0f} to {:.0f})\n",
        m.lighting_energy.value, m.lighting_energy.low, m.lighting_energy.high, m.lighting_saved.value,
        m.lighting_saved.low, m.lighting_saved.high);
  text += fmt::format("ASE1000,250h {} of the points; {:.0f} % of them are too near to tell\n",
                      part_of(m.sun_exposure), 100.0 * m.sun_too_near_to_tell);
  const auto exposure = leed_exposure_compliance(m.sun_exposure);
  text += fmt::format("LEED v4.1 option 1: {} of 3 points by sDA; ASE {}\n",
                      leed_points(m.autonomy_with_blinds.value),
                      exposure == Compliance::met       ? "at most 10 %"
                      : exposure == Compliance::not_met ? "above 10 %, which needs an explanation"
                                                        : "too near to 10 % to tell");
  text += fmt::format(
      "BREEAM: 300 lx in the mean for {:.0f} h ({:.0f} to {:.0f}), 90 lx at the darkest point for "
      "{:.0f} h ({:.0f} to {:.0f}); 2,000 h needed\n",
      year.hours_mean_300.value, year.hours_mean_300.low, year.hours_mean_300.high, year.hours_min_90.value,
      year.hours_min_90.low, year.hours_min_90.high);
  for (const auto& p : year.provision) text += text_of(p);
  return text + "glare and view out are not assessed, so there is no verdict on the whole\n";
}

Json json_of(const DaylightFactors& f) {
  return {{"cie_type", f.cie_type},
          {"albedo", f.albedo},
          {"mean", figure_json(f.mean)},
          {"median", figure_json(f.median)},
          {"minimum", figure_json(f.min)},
          {"uniformity", figure_json(f.min_over_mean)},
          {"mean_sky_component", mean_of(f.components[0])},
          {"mean_externally_reflected", mean_of(f.components[1])},
          {"mean_internally_reflected", mean_of(f.components[2])}};
}

Json json_of(const FactorProvision& p) {
  return {{"level", p.level},
          {"verdict", name(p.verdict)},
          {"target_factor", p.target_factor},
          {"minimum_factor", p.minimum_factor},
          {"points_on_target", figure_json(p.on_target)},
          {"points_on_minimum", figure_json(p.on_minimum)}};
}

Json json_of(const ClimateProvision& p) {
  return {{"level", p.level},
          {"target_lx", p.target},
          {"minimum_lx", p.minimum},
          {"by_points",
           {{"met", p.met_by_points},
            {"sure", p.sure_by_points},
            {"points_on_target", figure_json(p.points_on_target)},
            {"points_on_minimum", figure_json(p.points_on_minimum)}}},
          {"by_hours",
           {{"met", p.met_by_hours},
            {"sure", p.sure_by_hours},
            {"hours_on_target", figure_json(p.hours_on_target)},
            {"hours_on_minimum", figure_json(p.hours_on_minimum)}}}};
}

Json json_of(const YearReport& year) {
  const auto& m = year.metrics;
  Json json = {{"occupied_hours", m.occupied_hours},
               {"daylight_hours", year.daylight_hours},
               {"mean_daylight_autonomy", figure_json(m.autonomy.mean)},
               {"mean_continuous_daylight_autonomy", figure_json(m.continuous_autonomy.mean)},
               {"mean_udi_below_100", figure_json(m.below_100.mean)},
               {"mean_udi_100_3000", figure_json(m.useful.mean)},
               {"mean_udi_300_3000", figure_json(m.autonomous.mean)},
               {"mean_udi_above_3000", figure_json(m.above_3000.mean)},
               {"mean_annual_light_exposure_lxh", figure_json(m.exposure.mean)},
               {"mean_direct_sun_hours", figure_json(m.sun_hours.mean)},
               {"sda_300_50", figure_json(m.autonomy_of_space)},
               {"sda_300_50_with_blinds", figure_json(m.autonomy_with_blinds)},
               {"hours_with_blinds", m.hours_with_blinds},
               {"blinds", Json::array()},
               {"light_through_two_groups", year.light_taken_twice},
               {"points_too_near_to_tell", m.too_near_to_tell},
               {"ase_1000_250", figure_json(m.sun_exposure)},
               {"points_too_near_to_tell_ase", m.sun_too_near_to_tell},
               {"leed_v4_1_points", leed_points(m.autonomy_with_blinds.value)},
               {"breeam_hours_mean_300", figure_json(year.hours_mean_300)},
               {"breeam_hours_minimum_90", figure_json(year.hours_min_90)},
               {"en_17037_climate", Json::array()},
               {"not_assessed", {"glare", "view out"}}};
  for (const auto& p : year.provision) json["en_17037_climate"].push_back(json_of(p));
  for (const auto& group : m.blinds)
    json["blinds"].push_back({{"name", group.name},
                              {"transmittance", group.transmittance},
                              {"closed_hours", group.closed_hours},
                              {"part_of_light", group.part_of_light}});
  if (m.lighting_energy.value + m.lighting_saved.value > 0.0) {
    json["lighting_energy_kwh"] = figure_json(m.lighting_energy);
    json["lighting_saved_kwh"] = figure_json(m.lighting_saved);
  }
  return json;
}

}  // namespace

std::string summary_of(const DaylightReport& report) {
  std::string text;
  for (const auto& f : report.factors) text += text_of(f);
  text += components_text(report);
  for (const auto& p : report.provision) text += text_of(p);
  if (report.year) text += fmt::format("{}\n", report.place) + text_of(*report.year);
  if (!text.empty()) text.pop_back();
  return text;
}

std::string csv_of(const DaylightReport& report) {
  std::string text = "x,y,z,nx,ny,nz";
  for (const auto& f : report.factors)
    text += fmt::format(",daylight_factor_{0},daylight_factor_{0}_standard_error", f.cie_type);
  text += ",sky_component,externally_reflected,internally_reflected";
  if (report.year)
    text +=
        ",daylight_autonomy_300,daylight_autonomy_300_standard_error,continuous_daylight_autonomy_300,"
        "udi_below_100,udi_100_3000,udi_300_3000,udi_above_3000,annual_light_exposure_lxh,"
        "annual_light_exposure_standard_error_lxh,direct_sun_hours_1000,direct_sun_hours_1000_standard_error";
  text += "\n";
  for (std::size_t i = 0; i < report.points.position.size(); ++i) {
    const auto &at = report.points.position[i], &n = report.points.normal[i];
    text += fmt::format("{:g},{:g},{:g},{:g},{:g},{:g}", at.x, at.y, at.z, n.x, n.y, n.z);
    for (const auto& f : report.factors)
      text += fmt::format(",{:.6g},{:.3g}", f.value[i], f.standard_error[i]);
    for (const auto& part : report.factors.front().components) text += fmt::format(",{:.6g}", part[i]);
    if (report.year) {
      const auto& m = report.year->metrics;
      text += fmt::format(",{:.5g},{:.2g},{:.5g},{:.5g},{:.5g},{:.5g},{:.5g},{:.6g},{:.3g},{:.5g},{:.2g}",
                          m.autonomy.value[i], m.autonomy.standard_error[i], m.continuous_autonomy.value[i],
                          m.below_100.value[i], m.useful.value[i], m.autonomous.value[i],
                          m.above_3000.value[i], m.exposure.value[i], m.exposure.standard_error[i],
                          m.sun_hours.value[i], m.sun_hours.standard_error[i]);
    }
    text += "\n";
  }
  return text;
}

Json json_of(const DaylightReport& report) {
  Json json = {{"scene", report.scene},
               {"points", report.points.position.size()},
               {"sky_patches", report.sky_patches},
               {"openings_found", report.knows_openings},
               {"daylight_factors", Json::array()}};
  for (const auto& f : report.factors) json["daylight_factors"].push_back(json_of(f));
  if (!report.provision.empty()) {
    json["median_diffuse_illuminance_lx"] = report.median_diffuse;
    json["en_17037_daylight_factor"] = Json::array();
    for (const auto& p : report.provision) json["en_17037_daylight_factor"].push_back(json_of(p));
  }
  if (report.year) {
    json["place"] = report.place;
    json["year"] = json_of(*report.year);
  }
  return json;
}

std::string json_of(const DaylightReport& report, const std::vector<std::string>& outputs) {
  Json json = {{"command", "daylight"}};
  json.update(json_of(report));
  if (!outputs.empty()) json["outputs"] = outputs;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace luxel
