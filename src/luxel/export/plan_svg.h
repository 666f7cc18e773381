// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/export/luminaire_list.h"
#include "luxel/export/room_data.h"

namespace luxel {

// An observer whose glare is measured, in the plan.
struct PlanObserver {
  std::string name;          // one letter
  Vec3d eye{0.0};            // plan coordinates, m
  PlanPoint view{1.0, 0.0};  // unit
};

// The plan of a room: its outline with dimensions, luminaires to scale with their numbers from 1, observers
// with the directions that they look in, and a scale bar.
std::string plan_svg(const RoomData& room, const LuminaireList& luminaires,
                     const std::vector<PlanObserver>& observers);

}  // namespace luxel
