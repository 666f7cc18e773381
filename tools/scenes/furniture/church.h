// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenes/shapes/mesh.h"

namespace luxel::scenes {

// All closed, in metres, standing at the origin.

// A round column with a square base and a square head, `height` high in all.
Mesh column(double radius, double height, Paint stone);
Mesh pew(double length);  // along x, one sits facing -z
Mesh altar();             // a stone table with a cloth, 2.0 x 0.8
Mesh candlestick(double height);
Mesh candle_flame();  // shines; stands on y = 0
Mesh cross(double height);
Mesh font();  // a baptismal font of stone

}  // namespace luxel::scenes
