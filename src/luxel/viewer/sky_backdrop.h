// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/vector.h"
#include "luxel/viewer/full_screen_triangle.h"
#include "luxel/viewer/gl_object.h"
#include "luxel/viewer/surfaces.h"

namespace luxel {

// The sky behind all surfaces, with the horizon that pictures give it (render/sky_look.h). Needs the context
// that it was made in.
class SkyBackdrop {
 public:
  SkyBackdrop();

  // Covers the framebuffer that is bound; surfaces are drawn over it afterwards. view: its paint is light or
  // curve_input. radiance: of the sky, W/(m² sr); ground: see sky_look(); zenith: unit.
  void draw(const SurfaceView& view, const Vec3& radiance, double ground, const Vec3& zenith) const;

 private:
  FullScreenTriangle covers_;
  GlProgram plain_, local_, curve_input_;
};

}  // namespace luxel
