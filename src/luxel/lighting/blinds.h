// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "luxel/lighting/schedule.h"
#include "luxel/lighting/year.h"

namespace luxel {

// The rule of IES LM-83: the blinds of a group are closed in an occupied hour in which more than a part of
// the points has more than a limit straight from the sun, through the windows of this group.
struct BlindsRule {
  double limit = 1000.0;  // lx
  double part = 0.02;     // of the points
};

// State of the blinds of each group, hour by hour.
class Blinds {
 public:
  // Keeps a reference to the year. is_occupied: [hour of the year]. A schedule that states the blinds
  // replaces the rule.
  Blinds(const DaylightYear& year, const std::vector<bool>& is_occupied, const BlindsRule& rule,
         const YearSchedule& schedule);

  // Closed part of the blinds, [0, 1], [hour of the year].
  const std::vector<float>& closed(std::size_t group) const { return closed_[group]; }
  // Turns the light of all hours with open blinds, lx, which is DaylightYear::illuminance(left_out), into
  // that with these blinds.
  void apply(std::vector<float>& light, std::uint32_t left_out) const;

 private:
  const DaylightYear& year_;
  std::vector<std::vector<float>> closed_;  // [group][hour]
};

}  // namespace luxel
