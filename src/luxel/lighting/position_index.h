// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace luxel {

// Guth's position index of a glare source above the line of sight, at least 1: how much less a source
// disturbs there than on the line of sight. Bilinear in CIE 117:1995, table 4.1. t_over_r, h_over_r: distance
// to the side and height above the eye over the distance along the line of sight, 0 or more. Empty where the
// table has no number: t_over_r above 3, h_over_r above about 1.8; UGR ignores such sources.
std::optional<double> guth_index(double t_over_r, double h_over_r);

// Position index of a source anywhere; forward, aside, above: its place relative to the eye, m, in the axes
// of the observer. Below the line of sight, for which CIE 117 has no numbers: 1 + 0.8 r, or 1 + 1.2 r where r
// is 0.6 or more; r is the distance from the line of sight over the distance along it (Iwata and Tokura 1997,
// as in Radiance). Empty behind the observer.
std::optional<double> position_index(double forward, double aside, double above);

}  // namespace luxel
