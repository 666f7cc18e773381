// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

namespace luxel {

// Statistics of the view directions that meet a unit of neighbouring sides.
struct SeenUnit {
  double hits = 0.0;  // directions
  double sum = 0.0;   // over these, of the quantity in question
  double area = 0.0;  // m², above 0
};

// Returns the density of the sum in each unit, per m², as far as the hits tell it: a unit that many
// directions met has its own, one that few or none met that of its neighbourhood. Without this, of small
// patches those are taken for important that a direction happened to meet, and those between them for
// invisible.
//
// units: in an order in which neighbours stand together. The order is halved again and again; a half has the
// density
//
//     d (m + n) / (m + E)
//
// with d that of the whole, n the half's hits (each counted by its part of the sum), E those that d expects
// and m = tuning::seen::prior_hits: the posterior mean of a Poisson rate with a gamma prior of m hits, scaled
// so that the sum stays as it is. Cost: linear.
std::vector<double> pooled_densities(std::span<const SeenUnit> units);

}  // namespace luxel
