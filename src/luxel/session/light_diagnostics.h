// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/lamps/lamp_check.h"
#include "luxel/lamps/luminaire_check.h"
#include "luxel/session/light_walks.h"
#include "luxel/session/unlit.h"

namespace luxel {

// What is the matter with lamps: none at all, one that shines out of the scene or at a wall, one whose light
// never gets away from it.
void find_bad_lamps(const ScannedMesh& mesh, const PatchSet& patches, const std::vector<LampView>& views,
                    const LightWalks& walks, std::vector<Diagnostic>& diagnostics);

// Luminaires whose opening a surface crosses or hides.
void find_misplaced_luminaires(const ScannedMesh& mesh, const PatchSet& patches, const Tracer& tracer,
                               std::size_t places, std::vector<Diagnostic>& diagnostics);

// Light that leaves the scene, by the holes through which it does, and light that one-sided backs take.
void find_lost_light(const ScannedMesh& mesh, const PatchSet& patches, const LightWalks& walks,
                     const std::vector<Opening>& openings, std::size_t places,
                     std::vector<Diagnostic>& diagnostics);

// Surfaces that no light reaches, told by the components they belong to.
void find_dark_surfaces(const ScannedMesh& mesh, const PatchSet& patches, const Unlit& unlit,
                        std::size_t places, std::vector<Diagnostic>& diagnostics);

}  // namespace luxel
