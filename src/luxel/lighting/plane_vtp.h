// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "luxel/lighting/calculation_plane.h"

namespace luxel {

// The measured areas as VTK PolyData in XML (.vtp), which ParaView opens: a rectangle per point of a grid, a
// vertex per point of a line. Cell data: illuminance_lx, standard_error_lx, area (its index from 0), and
// cylindrical_lx (0 where it was not measured). Coordinates: those of the scene's file, m.
std::string vtp_of(std::span<const PlaneResult> results);

}  // namespace luxel
