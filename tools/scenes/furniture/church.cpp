// SPDX-License-Identifier: Apache-2.0
#include "scenes/furniture/church.h"

#include "scenes/shapes/sheets.h"
#include "scenes/shapes/solids.h"
#include "scenes/shapes/sweeping.h"
#include "scenes/shapes/turning.h"

namespace luxel::scenes {
namespace {

constexpr auto joint = 0.001;

}  // namespace

Mesh column(double radius, double height, Paint stone) {
  const auto r = radius;
  const auto plinth = 0.55 * r;
  const auto head = 0.60 * r;
  auto shaft = Profile{{0.0, plinth + joint}, {1.30 * r, plinth + joint}};
  // A torus, a hollow and a smaller torus; then the shaft, a little slimmer above; then the bell of the head.
  for (const auto& p : {glm::dvec2(1.42, 0.10),
                        {1.42, 0.24},
                        {1.30, 0.34},
                        {1.16, 0.40},
                        {1.13, 0.50},
                        {1.20, 0.58},
                        {1.18, 0.68},
                        {1.03, 0.74}}) {
    shaft.emplace_back(p.x * r, plinth + p.y * r);
  }
  const auto low = plinth + 0.80 * r;
  const auto high = height - head - 1.9 * r;
  for (auto k = 0; k <= 8; ++k) {
    const auto t = k / 8.0;
    shaft.emplace_back(r * (1.0 - 0.12 * t * t), low + (high - low) * t);
  }
  for (const auto& p : {glm::dvec2(0.98, 0.04),
                        {1.02, 0.12},
                        {0.96, 0.20},
                        {0.88, 0.24},
                        {0.90, 0.60},
                        {1.02, 1.10},
                        {1.26, 1.55},
                        {1.46, 1.80},
                        {1.46, 1.90 - joint}}) {
    shaft.emplace_back(p.x * r, high + p.y * r);
  }
  shaft.emplace_back(0.0, height - head - joint);
  return painted(
      joined({rounded_box({3.0 * r, plinth, 3.0 * r}, 0.02), lathe(shaft, r < 0.16 ? 18 : 36),
              moved(rounded_box({3.1 * r, head - joint, 3.1 * r}, 0.025), {0.0, height - head, 0.0})}),
      stone);
}

Mesh pew(double length) {
  auto mesh = Mesh{};
  append(mesh, placed(rounded_box({length - 0.09, 0.035, 0.40}, 0.012), {0.0, 0.42, -0.02}));
  append(mesh, placed(turned_x(rounded_box({length - 0.09, 0.50, 0.030}, 0.010), 8.0), {0.0, 0.47, 0.215}));
  append(mesh, placed(rounded_box({length - 0.09, 0.030, 0.10}, 0.010), {0.0, 0.975, 0.295}));
  append(mesh, placed(box({length - 0.09, 0.30, 0.022}), {0.0, 0.10, 0.12}));
  for (const auto x : {-0.5, 0.5}) {
    const auto side = prism({{-0.26, 0.0},
                             {0.33, 0.0},
                             {0.34, 0.96},
                             {0.28, 1.06},
                             {0.20, 1.02},
                             {0.08, 0.72},
                             {-0.20, 0.62},
                             {-0.26, 0.56}},
                            0.04);
    append(mesh, placed(moved(side, {0.0, 0.0, -0.02}), {x * (length - 0.04), 0.0, 0.0}, -90.0));
  }
  return painted(mesh, Paint::walnut);
}

Mesh altar() {
  const auto block = painted(rounded_box({1.80, 0.92, 0.70}, 0.02), Paint::stone_warm);
  const auto slab = painted(placed(rounded_box({2.00, 0.10, 0.84}, 0.02), {0.0, 0.921, 0.0}), Paint::marble);
  const auto cloth =
      painted(placed(rounded_box({1.30, 0.008, 0.86}, 0.003), {0.0, 1.022, 0.0}), Paint::linen_cloth);
  const auto fall = painted(placed(box({1.30, 0.36, 0.006}), {0.0, 0.668, 0.4265}), Paint::linen_cloth);
  const auto stripe = painted(placed(box({1.30, 0.05, 0.003}), {0.0, 0.70, 0.4325}), Paint::rug_rust);
  return joined({block, slab, cloth, fall, stripe});
}

Mesh candlestick(double height) {
  auto profile = Profile{{0.0, 0.0}};
  for (const auto& p : smooth({{0.30, 0.0},
                               {0.30, 0.03},
                               {0.10, 0.08},
                               {0.05, 0.16},
                               {0.09, 0.24},
                               {0.045, 0.32},
                               {0.04, 0.55},
                               {0.14, 0.62}},
                              2)) {
    profile.emplace_back(0.55 * p.x * height, p.y * height);
  }
  profile.emplace_back(0.0, 0.62 * height);
  return joined(
      {painted(lathe(profile, 18), Paint::brass),
       painted(moved(cylinder(0.022, 0.36 * height, 12), {0.0, 0.62 * height + joint, 0.0}), Paint::wax)});
}

Mesh candle_flame() {
  return painted(lathe({{0.0, 0.004}, {0.007, 0.014}, {0.010, 0.026}, {0.007, 0.044}, {0.0, 0.066}}, 10),
                 Paint::lamp_candle);
}

Mesh cross(double height) {
  const auto beam = 0.075 * height;
  return painted(joined({rounded_box({beam, height, beam}, 0.008),
                         moved(rounded_box({0.26 * height, beam, beam}, 0.008),
                               {-0.1685 * height - joint, 0.66 * height, 0.0}),
                         moved(rounded_box({0.26 * height, beam, beam}, 0.008),
                               {0.1685 * height + joint, 0.66 * height, 0.0})}),
                 Paint::walnut);
}

Mesh font() {
  auto profile = Profile{{0.0, 0.0},   {0.36, 0.0},  {0.36, 0.10}, {0.30, 0.14}, {0.15, 0.22}, {0.13, 0.50},
                         {0.18, 0.60}, {0.40, 0.78}, {0.42, 0.95}, {0.34, 0.95}, {0.26, 0.86}, {0.0, 0.84}};
  return painted(lathe(profile, 8), Paint::stone_warm);
}

}  // namespace luxel::scenes
