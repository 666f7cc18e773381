// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "luxel/core/context.h"
#include "luxel/import/placed_nodes.h"
#include "luxel/scene/scene.h"

namespace luxel {

// The lamps of KHR_lights_punctual where nodes place them, from candela and lux to W/sr and W/m². Positions
// are in metres (scale: metres per unit of the file), counted from the scene's origin, which must be in
// place.
void add_lamps(const GltfFile& file, std::span<const PlacedNode> nodes, double scale, Scene& scene);

// Adds the cameras too, in the order of nodes. Cameras without perspective are skipped, with a warning.
void add_cameras(const GltfFile& file, std::span<const PlacedNode> nodes, double scale, Scene& scene,
                 const Context& context);

// Position of a node, m, counted from the scene's origin. Throws InputError beyond `farthest`.
Vec3 gltf_place(const PlacedNode& placed, double scale, const Scene& scene);

// An axis of the node in scene coordinates, of length 1. Throws InputError where the node's scale is 0.
Vec3 gltf_axis(const PlacedNode& placed, const Vec3d& axis);

}  // namespace luxel
