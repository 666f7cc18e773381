// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/ugr_output.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "luxel/cli/verdict_json.h"
#include "luxel/lighting/calculation_plane.h"

namespace luxel {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t max_lines = 10;  // of the summary

Json triple(const Vec3d& v) { return {v.x, v.y, v.z}; }
Json number(double v) { return std::isfinite(v) ? Json(v) : Json(nullptr); }
std::string cell(double v) { return std::isfinite(v) ? fmt::format("{:.2f}", v) : std::string(); }

double sum_of(const ObservedGlare& glare) {
  double sum = 0.0;
  for (const auto& source : glare.sources) sum += source.glare();
  return sum;
}

Json observer_as_json(const UgrReport& report, std::size_t i) {
  const auto& g = report.glare[i];
  Json observer = {{"eye_m", triple(report.observers.position[i])},
                   {"view", triple(report.observers.normal[i])},
                   {"ugr", number(g.ugr)},
                   {"low", number(g.low)},
                   {"high", number(g.high)},
                   {"background_cd_per_m2", g.background},
                   {"background_error_cd_per_m2", g.background_error},
                   {"ignored", g.ignored},
                   {"large", g.large},
                   {"rays", g.rays},
                   {"reached", g.reached},
                   {"sources", Json::array()}};
  const auto sum = sum_of(g);
  for (const auto& s : g.sources)
    observer["sources"].push_back({{"name", s.name},
                                   {"position_m", triple(report.origin + s.position)},
                                   {"luminance_cd_per_m2", s.luminance},
                                   {"solid_angle_sr", s.solid_angle},
                                   {"visible", s.visible},
                                   {"position_index", s.position_index},
                                   {"contribution", s.glare() / sum}});
  return observer;
}

}  // namespace

std::string csv_of(const UgrReport& report) {
  std::string text =
      "x,y,z,nx,ny,nz,ugr,low,high,background_cd_per_m2,background_error_cd_per_m2,sources,ignored,rays,"
      "reached\n";
  for (std::size_t i = 0; i < report.glare.size(); ++i) {
    const auto& g = report.glare[i];
    const auto& eye = report.observers.position[i];
    const auto& view = report.observers.normal[i];
    text +=
        fmt::format("{:.9g},{:.9g},{:.9g},{:.6g},{:.6g},{:.6g},{},{},{},{:.5g},{:.3g},{},{},{},{}\n", eye.x,
                    eye.y, eye.z, view.x, view.y, view.z, cell(g.ugr), cell(g.low), cell(g.high),
                    g.background, g.background_error, g.sources.size(), g.ignored, g.rays, g.reached ? 1 : 0);
  }
  return text;
}

std::string json_of(const UgrReport& report, const UgrSettings& settings,
                    const std::vector<std::string>& outputs) {
  Json json = {{"command", "ugr"},
               {"solution", report.solution},
               {"error_target", settings.glare.error},
               {"max_rays", settings.glare.max_rays},
               {"lamp_rays", settings.glare.lamp_rays},
               {"seed", settings.glare.seed},
               {"solution_errors", name(report.solution_errors)},
               {"lamps", report.lamps},
               {"observers", Json::array()}};
  for (std::size_t i = 0; i < report.glare.size(); ++i)
    json["observers"].push_back(observer_as_json(report, i));
  for (const auto& [area, verdict] : report.verdicts) {
    auto judged = verdict_json(verdict);
    judged["area"] = area.empty() ? Json(nullptr) : Json(area);
    json["verdicts"].push_back(std::move(judged));
  }
  if (!outputs.empty()) json["outputs"] = outputs;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string summary_of(const UgrReport& report) {
  std::string text;
  std::size_t highest = 0;
  for (std::size_t i = 0; i < report.glare.size(); ++i) {
    const auto& g = report.glare[i];
    if (g.ugr > report.glare[highest].ugr) highest = i;
    if (i >= max_lines) continue;
    if (i > 0) text += "\n";
    if (!std::isfinite(g.ugr)) {
      text += fmt::format("observer {}: no UGR, {}", i + 1,
                          g.sources.empty() ? "no lamp dazzles" : "the background is dark");
      continue;
    }
    text += fmt::format(
        "observer {}: UGR {:.1f} ({:.1f} to {:.1f}), background {:.3g} cd/m², {} source{}, most "
        "by '{}' ({:.0f} %)",
        i + 1, g.ugr, g.low, g.high, g.background, g.sources.size(), g.sources.size() == 1 ? "" : "s",
        g.sources[0].name, 100.0 * g.sources[0].glare() / sum_of(g));
  }
  if (report.glare.size() > max_lines && std::isfinite(report.glare[highest].ugr))
    text += fmt::format("\n{} observers, highest UGR {:.1f} ({:.1f} to {:.1f}) of observer {}",
                        report.glare.size(), report.glare[highest].ugr, report.glare[highest].low,
                        report.glare[highest].high, highest + 1);
  for (const auto& [area, verdict] : report.verdicts)
    text += "\n" + (area.empty() ? "" : area + ": ") + sentence_of(verdict);
  return text;
}

std::vector<std::string> warnings_of(const UgrReport& report) {
  const auto n = report.glare.size();
  const auto count = [&](auto is_meant) {
    return std::count_if(report.glare.begin(), report.glare.end(), is_meant);
  };
  std::vector<std::string> warnings;
  if (report.lamps == 0)
    warnings.push_back(
        "the scene has no luminaire with an opening and no surface that emits, so that nothing can dazzle");
  if (const auto short_of = count([](const auto& g) { return !g.reached; }); short_of > 0)
    warnings.push_back(fmt::format(
        "the background of {} of {} observers has a larger error than requested: more --rays reduce it",
        short_of, n));
  if (const auto dark = count([](const auto& g) { return !(g.background > 0.0); }); dark > 0)
    warnings.push_back(
        fmt::format("{} of {} observers see a dark background: they are inside something, or face no surface "
                    "that light reaches",
                    dark, n));
  if (const auto large = count([](const auto& g) { return g.large > 0; }); large > 0)
    warnings.push_back(fmt::format(
        "{} of {} observers see a source above 0.1 sr, such as a luminous ceiling, for which UGR is not made",
        large, n));
  return warnings;
}

}  // namespace luxel
