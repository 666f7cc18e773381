// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/lighting/requirements.h"
#include "luxel/runs/option_set.h"

namespace luxel {

// The options for requirements of a plane that no file of areas describes.
struct RequirementSettings {
  std::string name;                                // of a table of requirements; empty: none
  std::vector<std::string> files;                  // with more tables
  double mean = 0.0, uniformity = 0.0, ugr = 0.0;  // override those of the table; 0: none

  // has_ugr: also --require-ugr.
  void declare(OptionSet& set, bool has_ugr);
  // True where the options require anything.
  bool is_given() const { return !name.empty() || mean > 0.0 || uniformity > 0.0 || ugr > 0.0; }
  // Throws UsageError where --requirements is of no use. has_areas: whether there is a file of areas.
  void check(bool has_areas) const;
  // The built-in requirements and those of the files. Throws InputError.
  RequirementTable table() const;
  // Throws UsageError where there is no requirement of this name.
  Requirement requirement() const;
};

// The table of requirements for people: name, numbers and source of each.
std::string text_of(const RequirementTable& table);
// The table of requirements as JSON.
std::string json_of(const RequirementTable& table);

}  // namespace luxel
