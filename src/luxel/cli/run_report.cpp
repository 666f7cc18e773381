// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/run_report.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "luxel/core/process_usage.h"
#include "luxel/runs/quantity.h"
#include "luxel/runs/refine_text.h"
#include "luxel/scene/luminous_efficacy.h"

namespace luxel {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Vec3d& v) { return {v.x, v.y, v.z}; }

Json to_json(const Camera& c, const Vec3d& origin) {
  return {{"eye", to_json(origin + Vec3d(c.eye))},
          {"target", to_json(origin + Vec3d(c.target))},
          {"up", to_json(Vec3d(c.up))},
          {"fov_degrees", c.vertical_fov}};
}

double total_area(const PatchSet& patches) {
  return std::accumulate(patches.area.begin(), patches.area.end(), 0.0);
}

bool has_standard_errors(const Solution& solution) { return !solution.standard_error.front.empty(); }

Json to_json(const Baked& baked) {
  const auto& s = baked.solution;
  Json json = {{"patches", baked.patches.size()},
               {"area_m2", total_area(baked.patches)},
               {"bands", s.bands},
               {"materials", baked.patches.materials.size()},
               {"method", s.provenance.method},
               {"seed", s.provenance.seed},
               {"rays", s.provenance.rays},
               {"stop_reason", name(s.stop)},
               {"unshot_fraction", s.unshot_fraction},
               {"predicted_error", s.predicted_error},
               {"standard_errors", has_standard_errors(s)},
               {"scene_fingerprint", fmt::format("{:016x}", s.provenance.scene_fingerprint)},
               {"program_version", s.provenance.program_version},
               {"command_line", s.provenance.command_line}};
  if (s.mesh_error > 0.0) json["mesh_error"] = s.mesh_error;
  if (s.error_95th > 0.0) json["error_95th"] = s.error_95th;
  if (s.seen_error > 0.0) json["seen_error"] = s.seen_error;
  if (baked.patches.has_sky()) json["sky_W_per_m2_sr"] = baked.patches.mean_sky();
  for (const auto& band : baked.patches.wavebands) {
    json["wavelengths_nm"].push_back(band.wavelength);
    json["widths_nm"].push_back(band.width);
  }
  return json;
}

Json steps_as_json(const SolveReport& report) {
  Json steps = Json::array();
  for (const auto& step : report.steps)
    steps.push_back({{"rays", step.rays}, {"unshot_fraction", step.unshot_fraction}});
  return steps;
}

Json rounds_as_json(const SolveReport& report) {
  Json rounds = Json::array();
  for (const auto& round : report.rounds)
    rounds.push_back({{"gather_rays", round.gather_rays},
                      {"shadow_rays", round.shadow_rays},
                      {"rays", round.rays},
                      {"seconds", round.seconds},
                      {"answer_seconds", round.answer_seconds},
                      {"error", round.error},
                      {"power_error", round.power_error},
                      {"uncertainty", round.uncertainty},
                      {"sweeps", round.sweeps},
                      {"residual", round.residual}});
  return rounds;
}

Json surfaces_as_json(const SurfaceMeans& means) {
  Json surfaces = Json::array();
  for (const auto& s : means.surfaces)
    surfaces.push_back({{"material", s.name},
                        {"side", s.is_back ? "back" : "front"},
                        {"area_m2", s.area},
                        {"irradiance_W_per_m2", s.irradiance},
                        {"standard_error_W_per_m2", s.standard_error}});
  return surfaces;
}

// reached: as the light states it.
Json to_json(const RefineReport& report, double target, double reached) {
  Json levels = Json::array();
  for (const auto& level : report.levels)
    levels.push_back({{"patches", level.patches},
                      {"mesh_error", level.mesh_error},
                      {"sampling_error", level.sampling_error},
                      {"rays", level.rays}});
  return {{"mesh_error", {{"target", target}, {"reached", reached}}},
          {"stop_reason", text_of(report.stop).name},
          {"levels", std::move(levels)}};
}

// The kind of error that a method states.
ErrorKind error_kind_of(const std::string& method) {
  if (method == "dense") return ErrorKind::integration;
  return method == "hemicube" ? ErrorKind::unknown : ErrorKind::noise;
}

std::string_view name(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::noise:
      return "noise";
    case ErrorKind::integration:
      return "integration";
    case ErrorKind::unknown:
      return "unknown";
  }
  return "";
}

Json error_as_json(const SolveReport& report, const std::optional<double>& target) {
  Json error = Json::object();
  if (target) error["target"] = *target;
  error["kind"] = name(report.error_kind);
  if (!report.rounds.empty() || report.seen_error > 0.0)
    error["measure"] = report.seen_error > 0.0 ? "seen" : "power";
  if (report.error_kind != ErrorKind::unknown) error["reached"] = error_of(report);
  if (report.seen_error > 0.0) {
    error["uncertainty"] = report.error_uncertainty;
    error["power"] = report.predicted_error;
    error["views"] = report.views;
    error["places"] = report.places;
  }
  if (report.error_95th > 0.0) error["percentile_95"] = report.error_95th;
  error["stop_reason"] = name(report.stop);
  return error;
}

Json ranks_as_json(const SolveReport& report) {
  auto each = Json::array();
  for (const auto& process : report.processes)
    each.push_back({{"rays", process.rays},
                    {"exchanges", process.exchanges},
                    {"received_bytes", process.received_bytes},
                    {"waited_seconds", process.waited_seconds},
                    {"processor_seconds", process.processor_seconds}});
  return {{"count", report.processes.size()},
          {"received_bytes", report.processes[0].received_bytes},
          {"waited_seconds", report.processes[0].waited_seconds},
          {"each", std::move(each)}};
}

Json to_json(const SolveReport& report, const std::optional<double>& target) {
  Json json = {{"error", error_as_json(report, target)}};
  if (!report.steps.empty()) json["steps"] = steps_as_json(report);
  if (!report.rounds.empty()) {
    json["rounds"] = rounds_as_json(report);
    json["unreached_sides"] = report.unreached_sides;
    json["streamed"] = report.streamed;
    json["predicted_memory_bytes"] = report.memory;
  }
  if (!report.processes.empty()) json["ranks"] = ranks_as_json(report);
  if (!report.means.surfaces.empty()) {
    json["surfaces"] = surfaces_as_json(report.means);
    const auto& received = report.means.received;
    json["received_W"] = {{"power", received.power}, {"standard_error", received.standard_error}};
  }
  const auto& e = report.energy;
  json["power_W"] = {{"emitted", e.emitted}, {"from_sky", e.from_sky},           {"absorbed", e.absorbed},
                     {"escaped", e.escaped}, {"lost_at_backs", e.lost_at_backs}, {"in_panes", e.in_panes},
                     {"unshot", e.unshot}};
  return json;
}

Json to_json(const PictureRecord& picture, const std::optional<double>& target) {
  Json error = Json::object();
  if (target) error["target"] = *target;
  error["reached"] = picture.error;
  error["stop_reason"] = name(picture.stop);
  return {{"paths_per_pixel", picture.paths}, {"rays", picture.rays}, {"error", std::move(error)}};
}

Json to_json(const PagesRecord& record) {
  const auto& texels = record.made.texels;
  const auto& seams = record.made.seams;
  Json json = {{"layout", record.as_file_has_it ? "file" : "new"},
               {"charts", record.made.charts},
               {"pages", record.pages},
               {"page_size", record.page_size},
               {"texels", texels.texels},
               {"gathered", texels.gathered},
               {"short_of_error", texels.short_of_it},
               {"rays", texels.rays},
               {"stopped", texels.stopped},
               {"seams",
                {{"places", seams.places},
                 {"difference_before", seams.difference_before},
                 {"difference_after", seams.difference_after}}}};
  if (record.error_target > 0.0) json["error_target"] = record.error_target;
  return json;
}

// Noise and bias as text. Values of 0 are not estimated, and left out.
std::string quality(ErrorKind kind, double seen_error, double error, double error_95th,
                    double unshot_fraction) {
  std::string text;
  if (seen_error > 0.0)
    text = fmt::format("seen error {:.2g} % (95 % of the views stay below)\n", 100.0 * seen_error);
  text += kind == ErrorKind::unknown
              ? std::string("this method knows no error of its own")
              : fmt::format("{} {:.2g} % (area-weighted relative RMS over patches)",
                            kind == ErrorKind::noise ? "standard error" : "error of the form factors below",
                            100.0 * error);
  if (error_95th > 0.0) text += fmt::format(", below {:.2g} % for 95 % of the lit sides", 100.0 * error_95th);
  if (unshot_fraction > 0.0) text += fmt::format(", bias below {:.2g} % unshot", 100.0 * unshot_fraction);
  return text;
}

std::string bands_as_text(const PatchSet& patches) {
  const auto& bands = patches.wavebands;
  if (bands.empty()) return fmt::format("bands {}", fmt::join(patches.bands, " "));
  return fmt::format("{} bands, wavelengths from {} to {} nm", bands.size(), bands.front().wavelength,
                     bands.back().wavelength);
}

// For a spectrum the sum, to which bands add up.
std::string sky_as_text(const PatchSet& patches) {
  const auto sky = patches.mean_sky();
  const auto* in_the_mean = patches.has_even_sky() ? "" : " in the mean";
  if (patches.wavebands.empty()) return fmt::format("{}{}", fmt::join(sky, " "), in_the_mean);
  return fmt::format("{:.4g}{}", std::accumulate(sky.begin(), sky.end(), 0.0), in_the_mean);
}

Json to_json(const RunRecord& record) {
  Json stages = Json::array();
  for (const auto& s : record.stages()) {
    Json stage = {{"name", s.name}, {"seconds", s.seconds}};
    if (s.rays > 0) {
      stage["rays"] = s.rays;
      stage["nanoseconds_per_ray"] = 1e9 * s.seconds / static_cast<double>(s.rays);
    }
    stages.push_back(std::move(stage));
  }
  return stages;
}

}  // namespace

std::string RunReport::as_json() const {
  Json json = {{"command", command}};
  if (baked) json["solution"] = to_json(*baked);
  if (refine)
    json["refine"] =
        to_json(*refine, mesh_error_target, baked ? baked->solution.mesh_error : refine->mesh_error);
  if (solve) json["solve"] = to_json(*solve, error_target);
  if (picture) json["picture"] = to_json(*picture, error_target);
  if (pages) json["pages"] = to_json(*pages);
  if (camera) json["camera"] = to_json(*camera, origin);
  if (picture_error > 0.0) json["picture_error"] = picture_error;
  if (!outputs.empty()) json["outputs"] = outputs;
  if (options) {
    for (const auto& [key, value] : options->values()) json["options"][key] = value;
  }
  if (record) {
    json["stages"] = to_json(*record);
    if (const auto seconds = record->first_light()) json["first_light_s"] = *seconds;
    if (const auto seconds = record->first_light_after_load()) json["first_light_after_load_s"] = *seconds;
    json["peak_memory_bytes"] = peak_memory();
  }
  // A file name may contain bytes that are not UTF-8; these are replaced, as dump() would throw.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string describe(const Baked& baked) {
  const auto& patches = baked.patches;
  const auto& s = baked.solution;
  auto text = fmt::format("{} patches, {:.4g} m², {} materials, {}\n", patches.size(), total_area(patches),
                          patches.materials.size(), bands_as_text(patches));
  if (patches.has_sky()) text += fmt::format("under a sky of {} W/(m² sr)\n", sky_as_text(patches));
  text += s.provenance.rays > 0 ? fmt::format("{} with {} rays, seed {}", s.provenance.method,
                                              s.provenance.rays, s.provenance.seed)
                                : s.provenance.method;
  text += fmt::format(": {}\n", description(s.stop));
  text += quality(error_kind_of(s.provenance.method), s.seen_error, s.predicted_error, s.error_95th,
                  s.unshot_fraction) +
          "\n";
  if (s.mesh_error > 0.0) text += fmt::format("mesh error {:.2g} %, apart from that\n", 100.0 * s.mesh_error);
  if (has_standard_errors(s))
    text += fmt::format("with the {} of every patch side\n",
                        s.provenance.method == "dense" ? "stated error" : "standard error");
  text +=
      fmt::format("scene {:016x}, luxel {}\n", s.provenance.scene_fingerprint, s.provenance.program_version);
  if (!s.provenance.command_line.empty()) text += s.provenance.command_line + "\n";
  return text;
}

std::string describe(const SolveReport& report) {
  const auto sum = [](const std::vector<double>& v) { return std::accumulate(v.begin(), v.end(), 0.0); };
  const auto& e = report.energy;
  const auto from_sky = sum(e.from_sky);
  const auto whole = sum(e.emitted) + from_sky;
  const auto percent = [&](const std::vector<double>& part) {
    return whole > 0.0 ? 100.0 * sum(part) / whole : 0.0;
  };
  const auto n = report.rounds.empty() ? report.steps.size() : report.rounds.size();
  auto done = n == 0
                  ? std::string()
                  : fmt::format("{} {}{}", n, report.rounds.empty() ? "bounce" : "round", n == 1 ? "" : "s");
  if (report.rays > 0) done += fmt::format("{}{} rays", done.empty() ? "" : ", ", report.rays);
  if (!done.empty()) done += "; ";
  auto text = fmt::format(
      "{}emitted {:.4g} W{} = absorbed {:.2f} % + escaped {:.2f} % + lost at backs {:.2f} % + {}unshot "
      "{:.2g} "
      "%\n",
      done, sum(e.emitted), from_sky > 0.0 ? fmt::format(" + from sky and sun {:.4g} W", from_sky) : "",
      percent(e.absorbed), percent(e.escaped), percent(e.lost_at_backs),
      sum(e.in_panes) > 0.0 ? fmt::format("in panes of glass {:.2f} % + ", percent(e.in_panes)) : "",
      percent(e.unshot));
  if (!report.processes.empty())
    text +=
        fmt::format("{} ranks: the first received {:.1f} MB from the others and waited {:.1f} s\n",
                    report.processes.size(), 1e-6 * static_cast<double>(report.processes[0].received_bytes),
                    report.processes[0].waited_seconds);
  if (report.streamed) text += "memory was short: hits were traced again for every sweep\n";
  return text + fmt::format("{}: {}", description(report.stop),
                            quality(report.error_kind, report.seen_error, report.predicted_error,
                                    report.error_95th, report.unshot_fraction));
}

}  // namespace luxel
