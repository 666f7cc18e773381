// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "luxel/patch/patch_set.h"
#include "luxel/viewer/surfaces.h"

namespace luxel {

// The luminous openings of luminaires on the graphics card: bodies that are as bright as pictures show them,
// see render/visible_luminaires.h. Needs the context that it was made in.
class LuminaireBodies {
 public:
  LuminaireBodies();
  ~LuminaireBodies();
  LuminaireBodies(const LuminaireBodies&) = delete;
  LuminaireBodies& operator=(const LuminaireBodies&) = delete;

  // Sets the luminaires of these patches, as dimmed and coloured there. No effect if they are set already.
  void set(const std::shared_ptr<const PatchSet>& patches);
  // Draws them over surfaces, which hide them unless they lie up to 5 mm behind. Only paints light,
  // curve_input and grey show them; the other ones show values of surfaces.
  void draw(const SurfaceView& view);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace luxel
