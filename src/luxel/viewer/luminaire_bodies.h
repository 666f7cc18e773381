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

  // The luminaires of these patches as they are dimmed and coloured there. Nothing where it has them already.
  void set(const std::shared_ptr<const PatchSet>& patches);
  // Over surfaces, which hide them but where they lie up to 5 mm behind. Paints light, curve_input and grey
  // show them; the other ones are for values of surfaces.
  void draw(const SurfaceView& view);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace luxel
