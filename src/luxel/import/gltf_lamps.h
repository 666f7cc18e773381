// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "luxel/core/log.h"
#include "luxel/import/placed_nodes.h"
#include "luxel/scene/scene.h"

namespace luxel {

// The lamps of KHR_lights_punctual where nodes place them, from candela and lux to W/sr and W/m². Positions
// are in metres (scale: metres per unit of the file), counted from the scene's origin, which must be in
// place.
void add_lamps(const GltfFile& file, std::span<const PlacedNode> nodes, double scale, Scene& scene);

// Likewise the cameras, in the order of nodes. Those without perspective are passed over, with a warning.
void add_cameras(const GltfFile& file, std::span<const PlacedNode> nodes, double scale, Scene& scene,
                 const LogSink& log);

}  // namespace luxel
