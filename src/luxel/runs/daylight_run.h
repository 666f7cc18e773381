// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "luxel/runs/daylight_study.h"
#include "luxel/runs/option_set.h"
#include "luxel/runs/relight_changes.h"

namespace luxel {

// Surfaces and panes of a stored run that are changed, by the names of their materials.
class DaylightChanges {
 public:
  void declare(OptionSet& set);
  bool any() const { return reflectances_.has_reflectance() || !transmittances_.empty(); }

  // Throws UsageError and InputError, beginning with the file, where names or values are wrong. Returns
  // whether rays must be traced again: the same ones, through other panes.
  bool apply(const std::string& file, PatchSet& patches) const;

 private:
  RelightChanges reflectances_;
  std::vector<std::string> transmittances_;  // NAME=TAU
};

// Writes the run of an answer, so that other weather, points, surfaces and panes need no new solve. command:
// reproduces the run. Throws DeviceError.
void write_daylight_run(const std::filesystem::path& path, const DaylightAnswer& answer,
                        const std::string& command);

struct StoredDaylight {
  DaylightTransport transport;
  Vec3d up{0.0, 0.0, 1.0};
  double north = 0.0;   // degrees, as north_of() has it
  int subdivision = 2;  // of the sky's patches
};
// Reads such a run and applies the changes. Throws InputError where the file holds no such run, and what
// read_stored_run() throws.
StoredDaylight read_daylight_run(const std::string& file, const DaylightChanges& changes,
                                 const Context& context);

}  // namespace luxel
