// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "luxel/classical/form_factor_row.h"
#include "luxel/classical/hemicube_pixels.h"
#include "luxel/classical/method_options.h"
#include "luxel/patch/patch_set.h"
#include "luxel/patch/side.h"

namespace luxel {

// Rows of form factors by the hemicube (Cohen and Greenberg 1985): the scene is drawn on the five faces of
// half a cube that stands on the patch, and each pixel gives its part of the cosine-weighted hemisphere to
// the nearest patch in it. Pixels have closed-form weights, so a row and its escaped part sum to 1.
//
// Errors of a row: it is that of points, not of the whole patch (use more points where patches are near each
// other), and a pixel belongs to one patch only (use a higher resolution where patches are small: a patch
// that no pixel centre sees gets nothing).
//
// An object is scratch memory for one thread: make one per thread. A row depends only on patches, options and
// side. Cost at 10,000 patches and a resolution of 128: about 2 ms per point; memory 10 bytes per pixel and
// 32 bytes per patch.
class Hemicube {
 public:
  // Keeps a reference to patches. Throws InputError where an option is out of its range.
  explicit Hemicube(const PatchSet& patches, const HemicubeOptions& options = {});

  // Replaces `row` by the row of this side. A patch without area sees nothing: all of its power escapes.
  void row(SideId side, FormFactorRow& row);

 private:
  // The pixels of one face: which side is nearest, and the reciprocal of its depth.
  struct Face {
    int rows = 0;
    std::vector<float> nearness;
    std::vector<SideId> side;
  };
  // A patch as seen from the eye: the planes through the eye and each edge, inside above; and the plane that
  // gives 1 / depth.
  struct Seen {
    std::array<Vec3d, 3> edge;
    Vec3d nearness;
    SideId side;
  };

  void look(const Vec3d& eye, const Vec3d& s, const Vec3d& t, const Vec3d& n, std::uint32_t own_patch);
  void draw(std::size_t face, const Seen& seen, const std::array<std::uint32_t, 3>& corners);
  void add_up(const Face& face, const std::vector<double>& pixels);

  const PatchSet& patches_;
  HemicubeOptions options_;
  HemicubePixels pixels_;
  std::array<Face, 5> faces_;
  std::vector<Vec3> local_;             // [vertex], relative to the eye
  std::vector<std::uint32_t> outside_;  // [vertex], bits: outside of which planes of which faces
  std::vector<double> sum_;             // [side]
  std::vector<SideId> met_;             // sides whose sum is not 0
  double escaped_ = 0.0;
};

}  // namespace luxel
