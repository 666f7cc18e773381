// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "luxel/image/tone.h"
#include "luxel/viewer/screen.h"

namespace luxel {

// Reinhard's local operator (ToneOperator::reinhard_local, equations 5 to 9) on the card: the light that each
// pixel is held against. image/tone_map.cpp does the same on the processor; here blurs wider than a pixel are
// made of means of 2 x 2 and 4 x 4 pixels. Some 40 looks at a texel per pixel. Needs the context it was made
// in.
class LocalTone {
 public:
  // Pixels around one, of which it knows nothing beyond: a part of a picture needs so many around it.
  static constexpr int reach = 48;

  LocalTone();
  ~LocalTone();
  LocalTone(const LocalTone&) = delete;
  LocalTone& operator=(const LocalTone&) = delete;

  // Makes it ready to be drawn into with Paint::curve_input, at this size. Throws DeviceError where the
  // driver has no picture of this size.
  void begin(ScreenSize size);
  // Finds the light around each pixel of what was drawn. pixel: how wide it is, in pixels of the picture that
  // people see; the scales go with these.
  void finish(const ToneCurve& curve, float pixel);
  // That light, for what is drawn from here on, as a texture of that unit.
  void use(int unit) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace luxel
