// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "luxel/import/luminaires.h"
#include "luxel/import/placed_nodes.h"
#include "luxel/scene/scene.h"

namespace luxel {

// Luminaires of a glTF file:
// - EXT_lights_ies: the node's axes are the luminaire's, which aims at the node's -Z; `multiplier` and
// `color`
//   scale its intensity, as the extension defines it;
// - extras of a node: "luminaire", the name of a photometric file beside the scene, and where needed
//   "luminaire_dimming", "luminaire_maintenance", "luminaire_group", "luminaire_turn" (degrees) and
//   "luminaire_lamp_set". On a node with a light of KHR_lights_punctual it replaces that light and aims as it
//   does, along -Z; on any other node it aims along -Y, straight down where the node is not turned.
// Positions as of add_lamps(), to be called before it.
void add_gltf_luminaires(GltfFile& file, std::span<const PlacedNode> nodes, double scale,
                         PhotometryStore& store, Scene& scene);

// True if the node's extras name a luminaire, which replaces its punctual light.
bool has_luminaire(const JsonValue& node);

}  // namespace luxel
