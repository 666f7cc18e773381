// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/lighting/metrics.h"
#include "luxel/lighting/window_groups.h"
#include "luxel/runs/option_set.h"

namespace luxel {

// Use of a room over a year, and operation of its blinds and lamps.
class YearSettings {
 public:
  void declare(OptionSet& options);
  // Throws UsageError where options need the weather of a year.
  void check(bool has_weather) const;
  // The groups of --blinds, with the transmittance of --blind-transmittance where they name none.
  std::vector<WindowGroup> groups() const;
  double transmittance() const {
    return transmittance_;
  }  // of the blinds of all windows, where none has a group
  // Reads the schedule, where one is given. Throws InputError.
  MetricOptions metrics(const Weather& weather) const;

 private:
  void parse_occupied(const std::string& text);
  void parse_blinds(const std::string& text);

  MetricOptions metrics_;
  std::vector<WindowGroup> groups_;  // transmittance below 0: not stated
  double transmittance_ = WindowGroup().transmittance;
  std::string schedule_;
};

}  // namespace luxel
