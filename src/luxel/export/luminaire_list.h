// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "luxel/export/plan_axes.h"
#include "luxel/lighting/ugr_table.h"
#include "luxel/patch/patch_set.h"

namespace luxel {

// Luminaires of one photometric file with the same dimming and maintenance factor.
struct LuminaireType {
  std::shared_ptr<const Photometry> photometry;
  std::size_t count = 0;
  double dimming = 1.0;      // part of the flux that they are set to
  double maintenance = 1.0;  // maintenance factor
  std::optional<UgrTable> ugr;
  std::string why_no_ugr;  // a sentence, where there is no table

  double flux() const { return photometry->intensity.zonal_flux(); }  // lm of one, initial, not dimmed
  // W of one with its lamps, not dimmed; nothing where the file does not state it.
  std::optional<double> watts() const;
  // The luminaire's name; where the file has none, the name of the file without its folder.
  std::string name() const;
};

// One luminaire of the plan.
struct PlacedLuminaire {
  std::size_t type = 0;            // index of LuminaireList::types
  Vec3d position{0.0};             // plan coordinates, m
  double turn = 0.0;               // degrees, anticlockwise: from the right of the sheet to its local X
  std::vector<PlanPoint> opening;  // its outline in the plan, m, at least 0.1 m wide so that it is seen
};

struct LuminaireList {
  std::vector<LuminaireType> types;     // in the order of the first luminaires
  std::vector<PlacedLuminaire> placed;  // in the order of the scene
  std::size_t other_lights = 0;         // points, spots and suns
  std::size_t lamp_surfaces = 0;        // connected surfaces that emit
  double flux = 0.0;                    // lm of all luminaires, initial, not dimmed
  std::optional<double> watts;          // W of all, not dimmed; nothing where one file does not state them
};

// Computes the UGR table of each type.
LuminaireList list_luminaires(const PatchSet& patches, const PlanAxes& axes);

// "rectangle, 0.60 × 0.60 m".
std::string text_of(const LuminousOpening& opening);

}  // namespace luxel
