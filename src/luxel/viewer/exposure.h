// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "luxel/image/tone.h"
#include "luxel/session/session_snapshot.h"
#include "luxel/viewer/pose.h"

namespace luxel {

// The view: pose, axes and aspect.
struct SeenFrom {
  const Pose& pose;
  const Space& space;
  float aspect;
};

// The tone curve for the view, which adapts gradually, like an eye.
class Exposure {
 public:
  // Forgets the scene: the next curve fits at once.
  void forget();
  // The curve for these options. automatic: moves from the last curve towards that which fits the view, over
  // about a third of a second; otherwise only the options' exposure changes. Cost: about 800 rays where it is
  // automatic and there is light.
  ToneCurve curve(const ToneOptions& options, bool automatic, const SessionLight* light, const SeenFrom& from,
                  double seconds);
  // Returns whether the curve has come to rest.
  bool is_settled() const { return is_settled_; }

 private:
  std::optional<float> base_;  // logarithm of the scale without the options' exposure
  ToneOptions fitted_;
  bool is_settled_ = true;
};

}  // namespace luxel
