// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "luxel/lighting/toml.h"

namespace luxel {

// Requirements of a standard or a client for an area. Absent values require nothing.
struct Requirement {
  std::string name = {};                     // "writing"
  std::string source = {};                   // where its numbers come from
  std::optional<double> Em = {}, Emin = {};  // lx: mean and minimum illuminance, at least; maintained
  std::optional<double> U0 = {}, Ud = {};    // minimum over mean and over maximum, at least
  std::optional<double> max_over_min = {};   // at most
  std::optional<double> Ez = {};             // lx: mean cylindrical illuminance, at least
  std::optional<double> modelling_min = {}, modelling_max = {};  // cylindrical over horizontal illuminance
  std::optional<double> E_wall = {}, E_ceiling = {};  // lx: means of these surfaces, for areas of these kinds
  std::optional<double> ugr = {};                     // at most; observers measure it
  std::optional<double> Ra = {};                      // at least; files of luminaires state it
};

// Requirements by name, of the tables that the program has and of files; of two with one name the later one
// counts.
class RequirementTable {
 public:
  // The rooms and tasks of EN 12464-1 and EN 1838 that the program has, see built_in_requirements.h.
  RequirementTable();
  // Adds the [requirement.NAME] tables of a file. Throws InputError with file and line.
  void add(const TomlFile& file);
  // Returns null where no requirement has this name.
  const Requirement* find(const std::string& name) const;
  const std::vector<Requirement>& all() const { return all_; }
  std::string names() const;  // "writing, filing, ..."

 private:
  std::vector<Requirement> all_;
};

// The keys that a requirement has in a file; an area may have them, too, and overrides single numbers.
const std::vector<std::string>& requirement_keys();
void read_requirement(const TomlKeys& keys, Requirement& requirement);

// The requirement of the surrounding area of a task area with this mean illuminance (EN 12464-1): 750 lx or
// more: 500; 500: 300; 300: 200; 200: 150; 150 or less: that of the task. Values between are those of the
// next larger task. Uniformity 0.40.
Requirement surround_of(double Em_task);
// The requirement of the background area: a third of the surround, uniformity 0.10.
Requirement background_of(double Em_task);

}  // namespace luxel
