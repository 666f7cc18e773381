// SPDX-License-Identifier: Apache-2.0
#include "scenes/furniture/office.h"

#include "scenes/shapes/dice.h"
#include "scenes/shapes/sheets.h"
#include "scenes/shapes/solids.h"
#include "scenes/shapes/sweeping.h"
#include "scenes/shapes/turning.h"

namespace luxel::scenes {
namespace {

constexpr auto joint = 0.001;  // parts stand this far apart: no two faces in one place

}  // namespace

Mesh office_desk() {
  auto mesh =
      painted(placed(rounded_box({1.60, 0.028, 0.80}, 0.008, {3, 0, 2}), {0.0, desk_height - 0.028, 0.0}),
              Paint::birch);
  constexpr auto under = desk_height - 0.028 - joint;
  for (const auto x : {-0.72, 0.72}) {
    append(mesh, painted(placed(rounded_box({0.06, 0.03, 0.72}, 0.010), {x, 0.0, 0.0}), Paint::steel_grey));
    append(mesh, painted(placed(rounded_box({0.05, under - 0.032, 0.09}, 0.012), {x, 0.031, -0.04}),
                         Paint::steel_grey));
  }
  append(mesh, painted(placed(box({1.37, 0.32, 0.018}), {0.0, under - 0.36, -0.05}), Paint::plastic_white));
  // A pedestal of three drawers.
  append(mesh,
         painted(placed(rounded_box({0.40, 0.56, 0.56}, 0.008), {0.46, 0.02, 0.06}), Paint::plastic_white));
  for (auto k = 0; k < 3; ++k) {
    append(mesh, painted(placed(rounded_box({0.38, 0.17, 0.014}, 0.005), {0.46, 0.035 + 0.18 * k, 0.349}),
                         Paint::plastic_white));
    append(mesh,
           painted(placed(box({0.14, 0.012, 0.014}), {0.46, 0.175 + 0.18 * k, 0.364}), Paint::steel_grey));
  }
  return mesh;
}

Mesh office_chair(Paint cloth) {
  auto mesh = Mesh{};
  for (auto k = 0; k < 5; ++k) {
    const auto arm = tube({{0.0, 0.085, 0.045}, {0.0, 0.065, 0.29}}, {0.020, 0.014}, 8);
    append(mesh, turned_y(arm, 72.0 * k));
    append(mesh, turned_y(moved(turned_z(moved(cylinder(0.028, 0.04, 12), {0.0, -0.02, 0.0}), 90.0),
                                {0.0, 0.029, 0.29}),
                          72.0 * k));
  }
  append(mesh, moved(cylinder(0.040, 0.06, 14), {0.0, 0.06, 0.0}));
  append(mesh, moved(cylinder(0.026, 0.29, 14), {0.0, 0.121, 0.0}));
  append(mesh, placed(rounded_box({0.24, 0.04, 0.26}, 0.010), {0.0, 0.412, 0.0}));
  append(mesh,
         tube(curve({0.0, 0.432, -0.135}, {0.0, 0.43, -0.30}, {0.0, 0.50, -0.295}, {0.0, 0.66, -0.275}, 6),
              0.018, 8));
  mesh = painted(mesh, Paint::plastic_black);
  for (const auto x : {-1.0, 1.0}) {
    append(mesh, painted(tube(curve({0.20 * x, 0.445, 0.0}, {0.31 * x, 0.445, 0.0}, {0.30 * x, 0.50, 0.0},
                                    {0.29 * x, 0.640, 0.0}, 6),
                              0.014, 8),
                         Paint::plastic_black));
    append(mesh, painted(placed(rounded_box({0.07, 0.024, 0.26}, 0.011), {0.29 * x, 0.642, 0.02}),
                         Paint::plastic_black));
  }
  append(mesh, painted(placed(cushion({0.48, 0.075, 0.46}, 0.035, 0.015), {0.0, 0.456, 0.02}), cloth));
  const auto back = deformed(rounded_box({0.44, 0.50, 0.055}, 0.026, {4, 4, 0}), [](const Vec3d& p) {
    const auto lean = p.y - 0.15;
    return Vec3d(p.x, p.y, p.z + 0.8 * p.x * p.x - 0.35 * lean * lean);
  });
  return joined({mesh, painted(placed(back, {0.0, 0.58, -0.228}), cloth)});
}

Mesh monitor() {
  const auto foot = painted(rounded_box({0.24, 0.012, 0.18}, 0.005), Paint::steel_grey);
  const auto neck =
      painted(placed(rounded_box({0.05, 0.30, 0.020}, 0.008), {0.0, 0.013, -0.03}), Paint::steel_grey);
  const auto frame_of_screen =
      painted(placed(rounded_box({0.56, 0.34, 0.022}, 0.006), {0.0, 0.17, -0.008}), Paint::plastic_black);
  const auto screen = painted(placed(box({0.54, 0.315, 0.002}), {0.0, 0.183, 0.005}), Paint::plastic_black);
  return joined(
      {foot, neck, frame_of_screen,
       painted(screen, Paint::lamp_monitor, [](const Vec3d&, const Vec3d& n) { return n.z > 0.9; })});
}

Mesh keyboard() {
  auto mesh = painted(rounded_box({0.44, 0.016, 0.13}, 0.005), Paint::plastic_white);
  for (auto row = 0; row < 4; ++row) {
    append(mesh,
           painted(placed(box({0.42, 0.005, 0.022}), {0.0, 0.017, -0.045 + 0.030 * row}), Paint::steel_grey));
  }
  return mesh;
}

Mesh paper_stack(std::uint64_t which) {
  auto mesh = Mesh{};
  auto y = 0.0;
  for (auto k = 0; k < 3; ++k) {
    const auto height = dice_between(0.004, 0.016, 81, which, 2u * k);
    append(mesh, painted(placed(box({0.21, height, 0.297}), {0.0, y, 0.0},
                                dice_between(-12.0, 12.0, 81, which, 2u * k + 1)),
                         Paint::paper));
    y += height + joint;
  }
  return mesh;
}

Mesh filing_cabinet(Paint body) {
  auto mesh = painted(placed(rounded_box({0.80, 1.18, 0.44}, 0.010), {0.0, 0.02, 0.0}), body);
  for (auto k = 0; k < 4; ++k) {
    const auto y = 0.035 + 0.29 * k;
    append(mesh, painted(placed(rounded_box({0.77, 0.28, 0.016}, 0.006), {0.0, y, 0.230}), body));
    append(mesh, painted(placed(rounded_box({0.20, 0.016, 0.018}, 0.006), {0.0, y + 0.20, 0.2485}),
                         Paint::steel_grey));
  }
  append(mesh, painted(box({0.74, 0.019, 0.38}), Paint::plastic_black));
  return mesh;
}

Mesh partition(double length, double height, Paint cloth) {
  const auto panel_of_cloth =
      painted(placed(rounded_box({length, height - 0.05, 0.045}, 0.020, {4, 3, 0}), {0.0, 0.05, 0.0}), cloth);
  auto mesh = panel_of_cloth;
  for (const auto x : {-0.5, 0.5}) {
    append(mesh, painted(placed(rounded_box({0.05, 0.048, 0.34}, 0.012), {x * (length - 0.2), 0.0, 0.0}),
                         Paint::steel_grey));
  }
  return mesh;
}

Mesh waste_bin() {
  return painted(
      lathe({{0.0, 0.0}, {0.115, 0.0}, {0.145, 0.32}, {0.135, 0.32}, {0.106, 0.012}, {0.0, 0.012}}, 24),
      Paint::plastic_black);
}

Mesh ceiling_luminaire_housing() {
  // The opening is 1.16 x 0.56 m, its frame 20 mm wide.
  return painted(turned_x(frame(1.16, 0.56,
                                {{0.0, 0.001}, {0.020, 0.001}, {0.020, 0.014}, {0.014, 0.020}, {0.0, 0.020}}),
                          90.0),
                 Paint::plastic_white);
}

Mesh ceiling_luminaire_panel(Paint lamp) {
  return painted(panel({-0.58, -0.006, -0.28}, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, steps({0.0, 1.16}, 0.3),
                       steps({0.0, 0.56}, 0.3)),
                 lamp);
}

}  // namespace luxel::scenes
