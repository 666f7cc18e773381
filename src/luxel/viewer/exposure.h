// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "luxel/image/tone.h"
#include "luxel/session/session_snapshot.h"
#include "luxel/viewer/pose.h"

namespace luxel {

// What is seen, and in which proportions.
struct SeenFrom {
  const Pose& pose;
  const Space& space;
  float aspect;
};

// The tone curve for what is in view, as an eye gets used to it.
class Exposure {
 public:
  // Another scene: the next curve fits at once.
  void forget();
  // The curve for these options. automatic: goes a part of the way from the last one towards what fits what
  // is seen, over about a third of a second; else stays where it was, but for the options' exposure.
  // Cost: about 800 rays where it is automatic and there is light.
  ToneCurve curve(const ToneOptions& options, bool automatic, const SessionLight* light, const SeenFrom& from,
                  double seconds);
  // Whether the curve has come to rest.
  bool is_settled() const { return is_settled_; }

 private:
  std::optional<float> base_;  // logarithm of the scale without the options' exposure
  ToneOptions fitted_;
  bool is_settled_ = true;
};

}  // namespace luxel
