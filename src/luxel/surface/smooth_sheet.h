// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "luxel/surface/light_sheets.h"
#include "luxel/surface/window_fit.h"
#include "luxel/surface/window_grid.h"

namespace luxel {

// Runs body(begin, end) over [0, count): on one thread or on many, in chunks that do not depend on it.
using LoopRunner =
    std::function<void(std::size_t count, const std::function<void(std::size_t, std::size_t)>& body)>;

// Receivers; sheets of fewer keep their own values.
inline constexpr std::size_t min_smoothed_sheet = 4;

// The input of the choices of smooth_sheet(). [index]
struct SmoothingWeights {
  // 1 over the square of the light relative to which an error is seen, (m²/W)².
  std::vector<float> risk;
  // Variance of the values, minus the part too small to be smoothed; any unit. Windows whose mean of it is
  // not above 0 keep their values.
  std::vector<float> noise;
};

// The change by the two finest scales, in the mean of the replicates: [index * bands + band]. Nearly all of
// it is removed noise, so that their bias cannot be estimated per receiver. It can be estimated from sums
// over many receivers.
struct FineChange {
  std::vector<float> product;   // of changes of different replicates, in which noise cancels: bias squared
  std::vector<float> variance;  // of the mean of half of the replicates
};

// The values to smooth.
struct SheetLight {
  std::vector<float>& values;        // [index * columns.size() + column], is replaced
  std::vector<float>& squared_bias;  // [index * bands + band], is written
  FineChange* fine = nullptr;        // is written; none where the replicates are not independent
};

// Local polynomial regression over one sheet, from fine windows to coarse ones.
//
// At each scale every window of a WindowGrid fits a polynomial (linear in the finest, else quadratic) to the
// values as the finer scales left them, and moves the values of its receivers towards the fit by the fraction
//
//     a = -C / (V + 4 max(0, D - 0.3 V)),
//
// which minimises the estimated risk: D the squared bias of the fit, V the variance of fit - value, C its
// covariance with the value, all summed over the window in units of the error that is seen. D is estimated
// without bias from products of different replicates, in which independent noise cancels. Windows overlap
// and their weights add up to 1, so that there are no seams; the spacing doubles from scale to scale up to
// the whole sheet. A shadow's edge or a corner makes D large, and its values stay. Each half of the
// replicates is moved by the fractions that the other half chose, so that the choice does not depend on the
// noise that it is applied to, and the spread of replicates stays an honest error. The mean over the sheet by
// area stays as it is. See docs/theory.md.
//
// Sources: local polynomial regression with a bandwidth chosen by the data, Fan and Gijbels 1995; from fine
// to coarse, Lepski 1991 and Katkovnik 1999; partition of unity, Shepard 1968; unbiased risk, Mallows 1973;
// choice by independent buffers, Rousselle, Knaus and Zwicker 2012.
//
// At least 4 replicates. squared_bias: an estimate of what all but the two finest scales get wrong, smoothed
// over the same windows; it may be below 0. Cost: 1 to 3 us per receiver of 8 replicates and 3 bands; about
// 500 bytes per receiver at a time.
//
// grids: see make_window_grids(), the finest first.
void smooth_sheet(const LightSheet& sheet, std::span<const WindowGrid> grids, WindowColumns columns,
                  const SmoothingWeights& weights, const SheetLight& light, const LoopRunner& run);

}  // namespace luxel
