// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/solution/solution.h"
#include "luxel/solve/pool_units.h"
#include "luxel/solve/replicate_spread.h"
#include "luxel/trace/gather_sides.h"
#include "luxel/trace/place_views.h"
#include "luxel/trace/seen_error.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// The seen error of a sampled solve, and which receivers it needs more rays for.
class SeenMeasure {
 public:
  // The importance of a unit of receivers is that of what the views meet there, or, for units that few
  // directions meet, in part that of its neighbourhood (pooled_densities()).
  enum class Pooling { unit, neighbourhood };

  // Places the views by the current patches; later calls use the lamps and reflectances of their time. See
  // place_views() for the cost. units: as neighbour_begins() gives them, the receivers whose importance is
  // pooled. Keeps references to patches and sides. All processes make the same.
  SeenMeasure(const PatchSet& patches, const GatherSides& sides, std::span<const std::uint32_t> units,
              const Tracer& tracer, const Context& context, Pooling pooling = Pooling::neighbourhood);

  // False where the scene has no open space: then there is no seen error.
  bool has_views() const { return !views_.empty(); }
  const ViewSets& views() const { return views_; }

  // The seen error of an answer.
  double error_of(const Spread& answer) const;

  // Takes a new answer and the replicates it is made of, direct and gathered light, [replicate][receiver *
  // bands + band]. With several processes, those of spread_partition() are enough. Cost: about 0.2 us per
  // receiver seen and 50 ns per direction, some 20 ms for a room of 50,000 patches.
  void take(const Spread& answer, Replicates direct, Replicates gathered, const Context& context);

  // Takes an answer without replicates: its uncertainty is 0.
  void take(const Spread& answer, const Context& context);

  // The error of the last answer taken.
  double error() const { return error_; }              // see Solution::seen_error
  double uncertainty() const { return uncertainty_; }  // its relative standard error, by the jackknife

  // Importance of each receiver, (m² / W)²: importance times the variance of the receiver's irradiance,
  // summed over bands (not averaged), summed over receivers, is about the square of error(). Some hundred
  // directions per view are sparse for a million sides, so how much the views look at a side is pooled over
  // each unit. A receiver's importance follows from that and its own radiance, at most that of the sides that
  // the views meet in its unit: a bright one does not count like the dark ones beside it, nor a dark one
  // that is hidden like the ones that are seen. A twentieth is distributed by area alone, for light that
  // reaches the views by surfaces outside them.
  std::span<const double> importance() const { return importance_; }  // [receiver]

 private:
  struct UnitAttention {
    Attention attention;      // weight per area, 1/m²
    double importance = 0.0;  // per area, of the sides that the views meet
  };

  bool is_diffuser(SideId side) const { return patches_.material_of(side.patch()).is_diffuser(); }
  bool is_black() const { return reflects_nothing(patches_, views_.stating); }
  SeenLight light_of(const Views& views, const Spread& answer) const;
  void take_importance(const Spread& answer, const Context& context);
  void estimate_uncertainty(const SeenError& seen, const SeenLight& light, const Spread& answer,
                            Replicates direct, Replicates gathered, const Context& context);
  double area_of(std::size_t receiver) const;                                        // m²
  std::vector<float> radiances(const Spread& answer, const Context& context) const;  // [receiver]
  std::vector<double> densities(std::span<const SeenUnit> units) const;              // 1/m², [unit]
  // of_seen: [index in Views::sides]; radiance: [receiver].
  std::vector<UnitAttention> attention_of_units(std::span<const Attention> of_seen,
                                                std::span<const float> radiance) const;
  void spread_importance(std::span<const Attention> of_seen, const Spread& answer, const Context& context);

  const PatchSet& patches_;
  const GatherSides& sides_;
  std::vector<std::uint32_t> units_;
  Pooling pooling_;
  ViewSets views_;
  double error_ = 0.0, uncertainty_ = 0.0;
  std::vector<double> importance_;
};

// The seen error of light with given errors, and the contribution of each side.
struct SeenSides {
  double error = 0.0;
  // [side], (m² / W)²: see SeenMeasure::importance(); empty: no open space was found
  std::vector<double> importance;
};
// irradiance, squared_error: [patch][band], W/m² and its square; a squared error is an estimate that may be
// below 0. Cost: that of place_views() and of a patch tree.
SeenSides seen_sides(const PatchSet& patches, const Tracer& tracer, const SideValues& irradiance,
                     const FrontAndBack<double>& squared_error, const Context& context);

// [patch], 1/m²: the fraction of the views of a place that a square metre of the patch and its neighbours
// fills, both sides together, summed over the places that see it; empty: no open space was found. Cost: that
// of place_views() and of a patch tree.
std::vector<double> seen_densities(const PatchSet& patches, const Tracer& tracer, const Context& context);

// The seen error of a solution (Solution::seen_error) from its light and the standard errors of its sides,
// with the same views as a solve of these patches has. widening: of the standard errors, see Solution; from
// error_degrees_of_freedom where that is above 0, else 1. 0 where the solution states no standard errors, or
// no open space is found. Cost: that of place_views().
double seen_error_of(const PatchSet& patches, const Tracer& tracer, const Solution& solution,
                     const Context& context);
// The same of the picture of a camera (Camera::aspect, else 4:3). Cost: about 4,000 rays.
double picture_error_of(const PatchSet& patches, const Tracer& tracer, const Solution& solution,
                        const Camera& camera);

}  // namespace luxel
