// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/requirements.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/lighting/built_in_requirements.h"

namespace luxel {
namespace {

constexpr double large_lux = 1e6, surround_uniformity = 0.40, background_uniformity = 0.10;
constexpr const char* rule = "EN 12464-1, from the task area";

Requirement named(std::string name, double Em, double U0) {
  Requirement r;
  r.name = std::move(name);
  r.source = rule;
  r.Em = Em;
  r.U0 = U0;
  return r;
}

}  // namespace

const std::vector<std::string>& requirement_keys() {
  static const std::vector<std::string> keys = {"source", "Em",           "Emin", "U0",
                                                "Ud",     "max_over_min", "Ez",   "modelling",
                                                "E_wall", "E_ceiling",    "UGR",  "Ra"};
  return keys;
}

void read_requirement(const TomlKeys& keys, Requirement& r) {
  if (const auto source = keys.text("source")) r.source = *source;
  const auto read = [&](const char* key, double min, double max, std::optional<double>& value) {
    if (const auto number = keys.number(key, min, max)) value = number;
  };
  read("Em", 0.0, large_lux, r.Em);
  read("Emin", 0.0, large_lux, r.Emin);
  read("U0", 0.0, 1.0, r.U0);
  read("Ud", 0.0, 1.0, r.Ud);
  read("max_over_min", 1.0, large_lux, r.max_over_min);
  read("Ez", 0.0, large_lux, r.Ez);
  read("E_wall", 0.0, large_lux, r.E_wall);
  read("E_ceiling", 0.0, large_lux, r.E_ceiling);
  read("UGR", 0.0, 40.0, r.ugr);
  read("Ra", 0.0, 100.0, r.Ra);
  if (const auto range = keys.numbers("modelling", 2)) {
    if (!((*range)[0] >= 0.0 && (*range)[0] < (*range)[1]))
      keys.refuse("modelling", "expected the smallest and the largest value, such as [0.30, 0.60]");
    r.modelling_min = (*range)[0];
    r.modelling_max = (*range)[1];
  }
}

RequirementTable::RequirementTable() { add(parse_toml(built_in_requirements, "the requirements of Luxel")); }

void RequirementTable::add(const TomlFile& file) {
  const std::string prefix = "requirement.";
  for (const auto& table : file.tables) {
    if (!table.name.starts_with(prefix)) continue;
    const TomlKeys keys(file.source, table, requirement_keys());
    Requirement r;
    r.name = table.name.substr(prefix.size());
    r.source = file.source;
    read_requirement(keys, r);
    std::erase_if(all_, [&](const Requirement& other) { return other.name == r.name; });
    all_.push_back(std::move(r));
  }
}

const Requirement* RequirementTable::find(const std::string& name) const {
  for (const auto& r : all_)
    if (r.name == name) return &r;
  return nullptr;
}

std::string RequirementTable::names() const {
  std::string names;
  for (const auto& r : all_) names += (names.empty() ? "" : ", ") + r.name;
  return names;
}

Requirement surround_of(double Em_task) {
  double Em = 500.0;
  for (const auto& [task, surround] :
       {std::pair{150.0, Em_task}, {200.0, 150.0}, {300.0, 200.0}, {500.0, 300.0}})
    if (Em_task <= task) {
      Em = surround;
      break;
    }
  return named("surround", Em, surround_uniformity);
}

Requirement background_of(double Em_task) {
  return named("background", *surround_of(Em_task).Em / 3.0, background_uniformity);
}

}  // namespace luxel
