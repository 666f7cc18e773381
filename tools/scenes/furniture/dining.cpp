// SPDX-License-Identifier: Apache-2.0
#include "scenes/furniture/dining.h"

#include "scenes/furniture/tables.h"
#include "scenes/shapes/solids.h"
#include "scenes/shapes/sweeping.h"
#include "scenes/shapes/turning.h"

namespace luxel::scenes {
namespace {

Mesh plate(double radius) {
  const auto r = radius;
  return lathe({{0.0, 0.0}, {0.60 * r, 0.0}, {r, 0.016}, {0.97 * r, 0.019}, {0.62 * r, 0.005}, {0.0, 0.005}},
               20);
}

Mesh backrest() {
  // A bent board: its ends come forward.
  const auto board = rounded_box({0.42, 0.17, 0.022}, 0.011, {4, 1, 0});
  return deformed(board, [](const Vec3d& p) { return Vec3d(p.x, p.y, p.z + 1.1 * p.x * p.x); });
}

}  // namespace

Mesh dining_table() {
  const auto top = lathe({{0.0, 0.0},
                          {0.58, 0.0},
                          {0.615, 0.008},
                          {0.625, 0.018},
                          {0.615, 0.028},
                          {0.60, 0.032},
                          {0.45, 0.032},
                          {0.30, 0.032},
                          {0.15, 0.032},
                          {0.0, 0.032}},
                         36);
  const auto outline =
      smooth({{0.30, 0.0}, {0.28, 0.02}, {0.10, 0.07}, {0.055, 0.25}, {0.06, 0.50}, {0.20, 0.715}}, 3);
  auto foot = Profile{{0.0, 0.0}};
  foot.insert(foot.end(), outline.begin(), outline.end());
  foot.emplace_back(0.0, 0.715);
  return joined({painted(placed(top, {0.0, dining_table_height - 0.032, 0.0}), Paint::oak),
                 painted(lathe(foot, 24), Paint::painted_wood)});
}

Mesh chair(Paint seat) {
  auto frame = Mesh{};
  for (const auto x : {-1.0, 1.0}) {
    append(frame, leg({0.21 * x, 0.0, 0.20}, {0.175 * x, 0.418, 0.165}, 0.011, 0.018));
    append(frame, leg({0.21 * x, 0.0, -0.22}, {0.165 * x, 0.418, -0.165}, 0.011, 0.018));
    // The post grows from the seat's corner and bends back.
    append(frame, tube(curve({0.165 * x, 0.462, -0.185}, {0.168 * x, 0.56, -0.19}, {0.17 * x, 0.66, -0.215},
                             {0.17 * x, 0.83, -0.265}, 5),
                       0.011, 8));
  }
  return joined({painted(frame, Paint::walnut),
                 painted(placed(rounded_box({0.43, 0.040, 0.42}, 0.020, {1, 0, 1}), {0.0, 0.420, 0.0}), seat),
                 painted(placed(turned_x(backrest(), -10.0), {0.0, 0.70, -0.215}), seat)});
}

Mesh place_setting() {
  return joined({painted(plate(0.135), Paint::porcelain),
                 painted(placed(plate(0.095), {0.0, 0.0062, 0.0}), Paint::glaze_turquoise),
                 placed(mug(Paint::glaze_cobalt), {0.19, 0.0, -0.07})});
}

}  // namespace luxel::scenes
