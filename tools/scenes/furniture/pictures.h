// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenes/shapes/mesh.h"

namespace luxel::scenes {

// Paper cut-outs in wooden frames, to hang in the plane z = 0 facing +z, centred at the origin.

enum class Motif { sunset, rainbow, moon };

Mesh picture_frame(double width, double height, Paint wood);   // closed; the size of the opening
Mesh picture_sheet(double width, double height, Motif motif);  // open: layers of paper

}  // namespace luxel::scenes
