// SPDX-License-Identifier: Apache-2.0
#include "luxel/apps/run_report.h"

#include <numeric>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "luxel/photometry/luminous_efficacy.h"

namespace luxel {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Vec3& v) { return {v.x, v.y, v.z}; }

Json to_json(const Camera& c) {
  return {{"eye", to_json(c.eye)},
          {"target", to_json(c.target)},
          {"up", to_json(c.up)},
          {"fov_degrees", c.vertical_fov}};
}

double total_area(const PatchSet& patches) {
  return std::accumulate(patches.area.begin(), patches.area.end(), 0.0);
}

Json to_json(const Baked& baked) {
  const auto& s = baked.solution;
  return {{"patches", baked.patches.size()},
          {"area_m2", total_area(baked.patches)},
          {"bands", s.bands},
          {"materials", baked.patches.materials.size()},
          {"method", s.provenance.method},
          {"seed", s.provenance.seed},
          {"rays", s.provenance.rays},
          {"stop", stop_name(s.stop)},
          {"unshot_share", s.unshot_share},
          {"predicted_error", s.predicted_error},
          {"scene_fingerprint", fmt::format("{:016x}", s.provenance.scene_fingerprint)},
          {"program_version", s.provenance.program_version},
          {"command_line", s.provenance.command_line}};
}

Json to_json(const SolveReport& report) {
  Json steps = Json::array();
  for (const auto& step : report.steps)
    steps.push_back({{"rays", step.rays}, {"unshot_share", step.unshot_share}});
  const auto& e = report.energy;
  return {{"steps", steps},
          {"power_W",
           {{"emitted", e.emitted},
            {"absorbed", e.absorbed},
            {"escaped", e.escaped},
            {"lost_at_backs", e.lost_at_backs},
            {"unshot", e.unshot}}}};
}

Json to_json(const RunRecord& record) {
  Json stages = Json::array();
  for (const auto& s : record.stages()) {
    Json stage = {{"name", s.name}, {"seconds", s.seconds}};
    if (s.rays > 0) {
      stage["rays"] = s.rays;
      stage["nanoseconds_a_ray"] = 1e9 * s.seconds / static_cast<double>(s.rays);
    }
    stages.push_back(std::move(stage));
  }
  return stages;
}

}  // namespace

std::string_view stop_name(StopReason reason) {
  switch (reason) {
    case StopReason::converged:
      return "converged";
    case StopReason::error_reached:
      return "error reached";
    case StopReason::ray_limit:
      return "ray limit";
    case StopReason::time_limit:
      return "time limit";
    case StopReason::stopped_by_user:
      return "stopped by user";
    case StopReason::nothing_to_do:
      return "nothing to do";
  }
  return "";
}

std::string RunReport::as_json() const {
  Json json = {{"command", command}};
  if (baked) json["solution"] = to_json(*baked);
  if (solve) json["solve"] = to_json(*solve);
  if (camera) json["camera"] = to_json(*camera);
  if (!outputs.empty()) json["outputs"] = outputs;
  if (options) {
    for (const auto& [key, value] : options->values()) json["options"][key] = value;
  }
  if (record) {
    json["stages"] = to_json(*record);
    json["peak_memory_bytes"] = peak_memory();
  }
  // A file name may hold bytes that are no UTF-8: those are replaced rather than thrown over.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string describe(const Baked& baked) {
  const auto& patches = baked.patches;
  const auto& s = baked.solution;
  auto text = fmt::format("{} patches, {:.4g} m², {} materials, bands {}\n", patches.size(),
                          total_area(patches), patches.materials.size(), fmt::join(s.bands, " "));
  text += fmt::format("{} with {} rays, seed {}: {}\n", s.provenance.method, s.provenance.rays,
                      s.provenance.seed, stop_name(s.stop));
  text += fmt::format(
      "standard error {:.2g} % (area-weighted relative RMS over patches), bias below {:.2g} % unshot\n",
      100.0 * s.predicted_error, 100.0 * s.unshot_share);
  text +=
      fmt::format("scene {:016x}, luxel {}\n", s.provenance.scene_fingerprint, s.provenance.program_version);
  if (!s.provenance.command_line.empty()) text += s.provenance.command_line + "\n";
  return text;
}

std::string describe(const SolveReport& report) {
  const auto sum = [](const std::vector<double>& v) { return std::accumulate(v.begin(), v.end(), 0.0); };
  const auto& e = report.energy;
  const auto emitted = sum(e.emitted);
  return fmt::format(
      "{} bounces, {} rays; emitted {:.4g} W = absorbed {:.2f} % + escaped {:.2f} % + lost at backs {:.2f} % "
      "+ unshot "
      "{:.2g} %",
      report.steps.size(), report.rays, emitted, 100.0 * sum(e.absorbed) / emitted,
      100.0 * sum(e.escaped) / emitted, 100.0 * sum(e.lost_at_backs) / emitted,
      100.0 * sum(e.unshot) / emitted);
}

}  // namespace luxel
