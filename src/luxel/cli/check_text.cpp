// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/check_text.h"

#include <cmath>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "luxel/cli/flags.h"
#include "luxel/cli/wrapped_text.h"
#include "luxel/core/process_usage.h"
#include "luxel/session/words.h"

namespace luxel {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t width = 110;

// used: columns of the first line that are taken; indent: of all others.
std::string within_width(const std::string& text, std::size_t used, std::size_t indent) {
  return wrapped(text, Margins{used, indent, width});
}

// With decimals down to a thousandth of the scene.
std::string at(const Vec3d& p, const CheckReport& report) {
  const auto size = report.box.size();
  const auto extent = std::max({size.x, size.y, size.z, 1e-30f});
  const auto decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(extent))), 0, 9);
  // Tiny numbers are printed as 0, and never as -0.
  const auto number = [&](double x) {
    const auto text = fmt::format("{:.{}f}", x, decimals);
    return text.find_first_not_of("-0.") == std::string::npos ? std::string("0") : text;
  };
  return fmt::format("({}, {}, {})", number(p.x), number(p.y), number(p.z));
}

// "room.obj:12  (1, 2, 3)  'chair' of 'oak': details".
std::string line_of(const Scene& scene, const Place& place, const CheckReport& report) {
  auto text = std::filesystem::path(scene.source).filename().string();
  if (place.line > 0) text += fmt::format(":{}", place.line);
  text += fmt::format("  {}  '{}'", at(place.at, report), place.group);
  if (place.material != place.group) text += fmt::format(" of '{}'", place.material);
  if (!place.detail.empty()) text += ": " + place.detail;
  return text;
}

std::string describe(const Scene& scene, const Diagnostic& diagnostic, const CheckReport& report) {
  constexpr std::size_t indent = 9;
  const std::string margin(indent, ' ');
  auto text = fmt::format(
      "\n{:<{}}{}\n", name(diagnostic.severity), indent,
      within_width(fmt::format("{}: {}", name(diagnostic.kind), diagnostic.fact), indent, indent));
  text += fmt::format("{}{}\n", margin, within_width("Luxel " + diagnostic.consequence, indent, indent));
  text += fmt::format("{}{}\n", margin,
                      within_width(with_flags(diagnostic.remedy, diagnostic.hints), indent, indent));
  for (const auto& place : diagnostic.places)
    text +=
        fmt::format("{}  {}\n", margin, within_width(line_of(scene, place, report), indent + 2, indent + 6));
  const auto more = diagnostic.all_places - diagnostic.places.size();
  if (more > 0 && !diagnostic.places.empty())
    text += fmt::format("{}  and {} more\n", margin, with_commas(more));
  return text;
}

std::string summary(const Scene& scene, const CheckReport& report) {
  const auto size = report.box.size();
  auto text = fmt::format("{}: {} in {} ({} closed), {:.4g} x {:.4g} x {:.4g} m, {:.4g} m²\n", scene.source,
                          counted_things(report.triangles, "triangle"),
                          counted_things(report.components, "connected component"),
                          with_commas(report.closed_components), size.x, size.y, size.z, report.area);
  const auto& walks = report.walks;
  if (walks.from == LightWalks::From::lamps)
    text +=
        fmt::format("light of the lamps, by {} paths: {} leaves the scene; {} of what it meets are backs\n",
                    with_commas(walks.paths), percent(walks.escaped), percent(walks.back_hits));
  if (walks.from == LightWalks::From::inside)
    text += fmt::format("views from inside, by {} rays: {} leave the scene; {} of what they meet are backs\n",
                        with_commas(walks.paths), percent(walks.escaped), percent(walks.back_hits));
  return text;
}

std::string verdict(const CheckReport& report) {
  if (!report.is_whole) return "\nstopped before all was looked at\n";
  if (report.diagnostics.empty()) return "\nnothing found\n";
  return fmt::format("\n{}, {}, {}\n", counted_things(report.count(Severity::error), "error"),
                     counted_things(report.count(Severity::warning), "warning"),
                     counted_things(report.count(Severity::note), "note"));
}

std::string legend(const CheckReport& report, const std::string& file) {
  std::vector<std::string> kinds;
  for (const auto& diagnostic : report.diagnostics) {
    auto entry = fmt::format("{} {}", colour(diagnostic.kind).word, name(diagnostic.kind));
    const bool is_shown = !diagnostic.triangles.empty() || !diagnostic.edges.empty();
    if (is_shown && (kinds.empty() || kinds.back() != entry)) kinds.push_back(std::move(entry));
  }
  std::string text = file + ": grey what is well";
  for (const auto& kind : kinds) text += ", " + kind;
  return within_width(text, 0, 2) + "\n";
}

Json to_json(const Vec3d& v) { return {v.x, v.y, v.z}; }

Json to_json(const Diagnostic& diagnostic) {
  Json places = Json::array();
  for (const auto& place : diagnostic.places)
    places.push_back({{"line", place.line},
                      {"object", place.object},
                      {"group", place.group},
                      {"material", place.material},
                      {"at_m", to_json(place.at)},
                      {"detail", place.detail}});
  return {{"kind", name(diagnostic.kind)},
          {"severity", name(diagnostic.severity)},
          {"count", diagnostic.count},
          {"fact", diagnostic.fact},
          {"consequence", diagnostic.consequence},
          {"remedy", with_flags(diagnostic.remedy, diagnostic.hints)},
          {"triangles", diagnostic.triangles.size()},
          {"colour", colour(diagnostic.kind).word},
          {"all_places", diagnostic.all_places},
          {"places", std::move(places)}};
}

std::string_view name(LightWalks::From from) {
  switch (from) {
    case LightWalks::From::lamps:
      return "lamps";
    case LightWalks::From::inside:
      return "inside";
    case LightWalks::From::nowhere:
      return "nowhere";
  }
  return "";
}

}  // namespace

std::string CheckText::as_text() const {
  auto text = summary(*scene, *report);
  for (const auto& diagnostic : report->diagnostics) text += describe(*scene, diagnostic, *report);
  text += verdict(*report);
  for (const auto& output : outputs) text += legend(*report, output);
  return text;
}

std::string CheckText::as_json() const {
  const auto& walks = report->walks;
  Json diagnostics = Json::array();
  for (const auto& diagnostic : report->diagnostics) diagnostics.push_back(to_json(diagnostic));
  Json json = {{"command", "check"},
               {"is_whole", report->is_whole},
               {"errors", report->count(Severity::error)},
               {"warnings", report->count(Severity::warning)},
               {"notes", report->count(Severity::note)},
               {"triangles", report->triangles},
               {"lit_triangles", report->lit_triangles},
               {"components", report->components},
               {"closed_components", report->closed_components},
               {"area_m2", report->area},
               {"low_m", to_json(scene->origin + Vec3d(report->box.low))},
               {"high_m", to_json(scene->origin + Vec3d(report->box.high))},
               {"light",
                {{"from", name(walks.from)},
                 {"paths", walks.paths},
                 {"escaped", walks.escaped},
                 {"escaped_error", walks.escaped_error},
                 {"escaped_at_once", walks.escaped_at_once},
                 {"lost_at_backs", walks.lost_at_backs},
                 {"back_hits", walks.back_hits}}},
               {"rays", report->rays},
               {"diagnostics", std::move(diagnostics)},
               {"outputs", outputs}};
  for (const auto& [key, value] : options->values()) json["options"][key] = value;
  Json stages = Json::array();
  for (const auto& stage : record->stages())
    stages.push_back({{"name", stage.name}, {"seconds", stage.seconds}});
  json["stages"] = std::move(stages);
  json["peak_memory_bytes"] = peak_memory();
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace luxel
