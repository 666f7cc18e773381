// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "luxel/image/tone.h"
#include "luxel/viewer/screen.h"

namespace luxel {

// Reinhard's local operator (ToneOperator::reinhard_local, equations 5 to 9) on the card: the
// adaptation luminance of each pixel. image/tone_map.cpp does the same on the processor; here blurs
// wider than a pixel use means of 2 x 2 and 4 x 4 pixels. Cost: about 40 texel reads per pixel. Needs
// the context it was made in.
class LocalTone {
 public:
  // Radius of influence, pixels: a part of a picture needs this margin.
  static constexpr int reach = 48;

  LocalTone();
  ~LocalTone();
  LocalTone(const LocalTone&) = delete;
  LocalTone& operator=(const LocalTone&) = delete;

  // Makes it ready to be drawn into with Paint::curve_input, at this size. Throws DeviceError where the
  // driver has no picture of this size.
  void begin(ScreenSize size);
  // Finds the light around each pixel of what was drawn. pixel: its width in pixels of the displayed picture,
  // in which the scales are defined.
  void finish(const ToneCurve& curve, float pixel);
  // Binds that light as the texture of this unit, for later drawing.
  void use(int unit) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace luxel
