// SPDX-License-Identifier: Apache-2.0
#include "scenes/furniture/window.h"

#include "scenes/shapes/sheets.h"
#include "scenes/shapes/solids.h"
#include "scenes/shapes/sweeping.h"

namespace luxel::scenes {

Mesh reveal(const Opening& opening) {
  const auto [w, h, d] = opening;
  const auto x = Vec3d(w, 0.0, 0.0);
  const auto y = Vec3d(0.0, h, 0.0);
  const auto out = Vec3d(0.0, 0.0, -d);
  const auto corner = Vec3d(-0.5 * w, -0.5 * h, 0.0);
  const auto across = steps({0.0, 1.0}, 0.25);
  const auto inwards = std::vector<double>{0.0, 1.0};
  return painted(
      joined({panel(corner, x, out, across, inwards), panel(corner + y + out, x, -out, across, inwards),
              panel(corner + out, y, -out, across, inwards), panel(corner + x, y, out, across, inwards)}),
      Paint::painted_wood);
}

Mesh window_frame(const Opening& opening) {
  const auto [w, h, d] = opening;
  constexpr auto joint = 0.001;
  constexpr auto bar = 0.045;
  const auto z = -0.55 * d;
  // The casing's outer edge stays a joint away from the reveal.
  const auto casing = frame(w - 2.0 * (bar + joint), h - 2.0 * (bar + joint),
                            {{0.0, 0.0}, {bar, 0.0}, {bar, 0.05}, {0.0, 0.05}});
  const auto inner = h - 2.0 * (bar + 2.0 * joint);
  auto mesh = moved(casing, {0.0, 0.0, z});
  for (const auto x : {-w / 6.0, w / 6.0}) {
    append(mesh, placed(box({0.034, inner, 0.036}), {x, -0.5 * inner, z + 0.025}));
  }
  const auto third = w / 3.0 - 0.034;
  const auto side = third - 0.5 * bar - 0.017;
  const auto y = 0.18 * h;
  append(mesh, placed(box({third - 2.0 * joint, 0.028, 0.032}), {0.0, y, z + 0.025}));
  for (const auto sign : {-1.0, 1.0}) {
    append(mesh,
           placed(box({side, 0.028, 0.032}), {sign * (w / 6.0 + 0.017 + joint + 0.5 * side), y, z + 0.025}));
  }
  append(mesh, placed(rounded_box({w + 0.10, 0.035, 0.16}, 0.012), {0.0, -0.5 * h - 0.036, 0.082}));
  return painted(mesh, Paint::painted_wood);
}

}  // namespace luxel::scenes
