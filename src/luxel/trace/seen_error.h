// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "luxel/patch/patch_set.h"
#include "luxel/patch/side.h"
#include "luxel/trace/views.h"

namespace luxel {

// Light as an eye receives it: root mean squares over bands.
struct SeenLight {
  std::vector<float> radiance;  // [index in Views::sides], W/(m² sr), emission included
  // Squared error of the radiance: standard error and bias, not widened by Student's t. The bias is an
  // estimate and may be below 0: only its sum over a view is meaningful.
  std::vector<float> squared_error;
  float sky = 0.0f;  // radiance of the sky
};

// One side's part of SeenLight.
struct SeenSide {
  float radiance = 0.0f;
  float squared_error = 0.0f;
};

// Returns whether nothing that the views see reflects: then irradiance stands for radiance, as if all
// reflectances were 1, so that the light of black rooms has an error too.
bool reflects_nothing(const PatchSet& patches, const Views& views);

// The light that arrives at one side, [band], W/m², and its squared error.
struct SideEstimate {
  std::vector<float> irradiance;
  std::vector<double> squared_error;
};
// far: of the other side, whose light a diffuser transmits, with an independent error. black: see
// reflects_nothing().
SeenSide light_of_side(const PatchSet& patches, SideId side, const SideEstimate& here,
                       const SideEstimate& far, bool black);

// The root mean square over bands of the radiance of the sky.
float sky_radiance(const PatchSet& patches);

// How much the views look at a side, whatever its light, and what their eyes adapt to.
struct Attention {
  double weight = 0.0;
  double adaptation = 0.0;  // W/(m² sr), mean over these views; 0 where there are none

  // The effect on the views of a squared error of 1 (W/(m² sr))², for a radiance in W/(m² sr).
  double importance(double radiance) const {
    const auto level = radiance + adaptation;
    return level > 0.0 ? weight / (level * level) : 0.0;
  }
};

// The error that can be seen from each view: the root mean square, over the directions that meet a surface in
// the focus, of
//
//     e = s / (L + 0.05 a),
//     a = mean over directions of min(L, 10 median L),
//         at least 0.1 of the median of a over all views
//
// with L the radiance of the side met and s its standard error. a is the level that an eye adapts to; it
// includes sky and lamps. The floor keeps a dark cavity with a leak from dominating the error.
//
// Views in the dark count neither in that median nor in percentile_95(): those whose eye adapts to less than
// 1/10,000 of what nine views of ten (by weight) stay below, even if all light were brighter by its standard
// error. They are below the floors and outside the walls of lit rooms, where light only leaks through cracks.
// Views of cameras always count.
class SeenError {
 public:
  // Keeps references. Cost: about 5 ns per direction.
  SeenError(const Views& views, const SeenLight& light);

  std::span<const double> of_view() const { return error_; }  // [view]
  // The error that 95 % of the views stay below, by weight; 0 without views.
  double percentile_95() const;
  // The same percentile for other squared errors of the sides seen, at the same radiances.
  double percentile_95(std::span<const float> squared_error) const;

  // Returns how much each side counts, [index in Views::sides]. At its own radiance L its importance is
  //
  //     sum over views of u f / (L + 0.05 a)²,    u = weight min(e, e95)^4,
  //
  // with f the fraction of the view that the side fills, e the error of the view and e95 = percentile_95():
  // the worst views count most. Scaled so that the sum over sides of importance times squared error is e95².
  // Importance of Smits, Arvo and Salesin 1992, with views in place of one picture.
  std::vector<Attention> attention() const;

 private:
  std::vector<double> errors(std::span<const float> squared_error) const;
  // Of the directions of a view, with errors_added standard errors added to each.
  std::vector<double> radiances(std::size_t view, double errors_added) const;
  void leave_out_dark_views();

  const Views& views_;
  const SeenLight& light_;
  std::vector<float> weight_;       // [view], they add up to 1; 0: in the dark
  std::vector<double> adaptation_;  // [view], 0.05 a, W/(m² sr)
  std::vector<double> error_;       // [view]
};

}  // namespace luxel
