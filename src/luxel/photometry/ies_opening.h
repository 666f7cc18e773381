// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "luxel/photometry/photometry.h"

namespace luxel {

// The luminous opening that the signs of an IES file's width, length and height stand for. version: 1986,
// 1991, 1995, 2002 or 2019; sizes in m; type: of the photometry, whose width lies along Y in type C and along
// X in types A and B. Nothing where no version has such signs. is_other: set where another version's
// signs were used.
std::optional<LuminousOpening> opening_of(int version, GoniometerType type, const Vec3d& width_length_height,
                                          bool& is_other);

}  // namespace luxel
