// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/requirement_settings.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace luxel {
namespace {

using Json = nlohmann::ordered_json;

std::string cell(const std::optional<double>& value) { return value ? fmt::format("{:g}", *value) : "-"; }

std::string modelling_of(const Requirement& r) {
  return r.modelling_min ? fmt::format("{:g}-{:g}", *r.modelling_min, *r.modelling_max) : "-";
}

Json as_json(const Requirement& r) {
  Json json = {{"name", r.name}, {"source", r.source}};
  const auto add = [&](const char* key, const std::optional<double>& value) {
    if (value) json[key] = *value;
  };
  add("Em", r.Em);
  add("Emin", r.Emin);
  add("U0", r.U0);
  add("Ud", r.Ud);
  add("max_over_min", r.max_over_min);
  add("Ez", r.Ez);
  add("E_wall", r.E_wall);
  add("E_ceiling", r.E_ceiling);
  add("UGR", r.ugr);
  add("Ra", r.Ra);
  if (r.modelling_min) json["modelling"] = {*r.modelling_min, *r.modelling_max};
  return json;
}

}  // namespace

void RequirementSettings::declare(OptionSet& set, bool has_ugr) {
  set.add_text(
      "requirement", "NAME", name,
      "what is required of the plane: a row of the table of requirements, such as writing; empty: none");
  set.add_texts(
      "requirements", "FILE", files,
      "TOML file with more [requirement.NAME] tables, for --requirement and --areas; may be repeated");
  set.add_number("require-mean", "lx", mean, 0.0, 1e7,
                 "required mean illuminance of the plane, such as 500; 0: none, or that of --requirement");
  set.add_number("require-uniformity", "ratio", uniformity, 0.0, 1.0,
                 "required uniformity U0, minimum over mean, such as 0.6; 0: none, or that of --requirement");
  if (has_ugr)
    set.add_number("require-ugr", "UGR", ugr, 0.0, 100.0,
                   "largest UGR that observers may have, such as 19; 0: none, or that of --requirement");
}

void RequirementSettings::check(bool has_areas) const {
  if (!files.empty() && !has_areas && name.empty())
    throw UsageError("--requirements belongs to --areas or --requirement");
}

RequirementTable RequirementSettings::table() const {
  RequirementTable table;
  for (const auto& file : files) table.add(read_toml(file));
  return table;
}

Requirement RequirementSettings::requirement() const {
  Requirement required;
  if (!name.empty()) {
    const auto all = table();
    const auto* found = all.find(name);
    if (found == nullptr)
      throw UsageError(
          fmt::format("--requirement: there is no requirement '{}'; expected one of {}, or --requirements "
                      "with a file that "
                      "defines it",
                      name, all.names()));
    required = *found;
  }
  if (mean > 0.0) required.Em = mean;
  if (uniformity > 0.0) required.U0 = uniformity;
  if (ugr > 0.0) required.ugr = ugr;
  return required;
}

std::string text_of(const RequirementTable& table) {
  std::size_t width = 4;
  for (const auto& r : table.all()) width = std::max(width, r.name.size());
  auto text =
      fmt::format("{:<{}}  {:>5} {:>5} {:>5} {:>5} {:>4} {:>4} {:>4} {:>6} {:>7} {:>9}  {}\n", "name", width,
                  "Em", "Emin", "U0", "Emax/", "UGR", "Ra", "Ez", "E_wall", "E_ceil.", "modelling", "source");
  text += fmt::format("{:<{}}  {:>5} {:>5} {:>5} {:>5} {:>4} {:>4} {:>4} {:>6} {:>7} {:>9}\n", "", width,
                      "lx", "lx", "", "Emin", "", "", "lx", "lx", "lx", "");
  for (const auto& r : table.all())
    text += fmt::format("{:<{}}  {:>5} {:>5} {:>5} {:>5} {:>4} {:>4} {:>4} {:>6} {:>7} {:>9}  {}\n", r.name,
                        width, cell(r.Em), cell(r.Emin), cell(r.U0), cell(r.max_over_min), cell(r.ugr),
                        cell(r.Ra), cell(r.Ez), cell(r.E_wall), cell(r.E_ceiling), modelling_of(r), r.source);
  return text;
}

std::string json_of(const RequirementTable& table) {
  Json json = {{"requirements", Json::array()}};
  for (const auto& r : table.all()) json["requirements"].push_back(as_json(r));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace luxel
