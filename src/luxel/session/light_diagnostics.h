// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/lamps/lamp_check.h"
#include "luxel/lamps/luminaire_check.h"
#include "luxel/session/light_walks.h"
#include "luxel/session/unlit.h"

namespace luxel {

// Finds defects of lamps: a scene without lamps, lamps that shine out of the scene or at a wall, and lamps
// whose light stays enclosed.
void find_bad_lamps(const ScannedMesh& mesh, const PatchSet& patches, const std::vector<LampView>& views,
                    const LightWalks& walks, std::vector<Diagnostic>& diagnostics);

// Finds luminaires whose opening a surface crosses or hides.
void find_misplaced_luminaires(const ScannedMesh& mesh, const PatchSet& patches, const Tracer& tracer,
                               std::size_t places, std::vector<Diagnostic>& diagnostics);

// Reports light that leaves the scene, per hole, and light that the backs of one-sided materials absorb.
void find_lost_light(const ScannedMesh& mesh, const PatchSet& patches, const LightWalks& walks,
                     const std::vector<Opening>& openings, std::size_t places,
                     std::vector<Diagnostic>& diagnostics);

// Finds surfaces that no light reaches, reported by connected component.
void find_dark_surfaces(const ScannedMesh& mesh, const PatchSet& patches, const Unlit& unlit,
                        std::size_t places, std::vector<Diagnostic>& diagnostics);

}  // namespace luxel
