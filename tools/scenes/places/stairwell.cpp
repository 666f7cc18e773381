// SPDX-License-Identifier: Apache-2.0
// A winding staircase of two and a half turns round an open well, under a round skylight.

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "scenes/places/places.h"
#include "scenes/shapes/sheets.h"
#include "scenes/shapes/solids.h"
#include "scenes/shapes/sweeping.h"
#include "scenes/shapes/turning.h"

namespace luxel::scenes {
namespace {

constexpr auto steps_per_turn = 22;
constexpr auto step_count = 55;
constexpr auto rise = 0.165;
constexpr auto well = 1.25;  // m, radius of the open middle
constexpr auto wall = 2.75;  // m, inner radius of the tower
constexpr auto wall_gap = 0.002;
constexpr auto slab = 0.16;      // m, from a tread's back edge down to the soffit
constexpr auto pieces = 2;       // of a tread, round the axis
constexpr auto head = 2.9;       // m of room above the landing
constexpr auto skylight = 1.35;  // m, radius
constexpr auto landing = step_count * rise;
constexpr auto top = landing + head;

constexpr auto tower_segments = 2 * steps_per_turn;

double angle_of(double step) { return 2.0 * std::numbers::pi * step / steps_per_turn; }

Vec3d at(double step, double radius, double y) {
  return {radius * std::cos(angle_of(step)), y, -radius * std::sin(angle_of(step))};
}

double soffit(double step) { return std::max(0.003, rise * step - slab); }

constexpr std::array radial = {well, well + 0.5, well + 1.0, wall - wall_gap};

// Where the soffit has left the floor. The first steps are solid.
void add_step(Mesh& mesh, int k) {
  const auto y = rise * (k + 1);
  for (auto piece = 0; piece < pieces; ++piece) {
    const auto a = k + static_cast<double>(piece) / pieces;
    const auto b = k + static_cast<double>(piece + 1) / pieces;
    const auto quad = [&](const Vec3d& p, const Vec3d& q, const Vec3d& r, const Vec3d& s) {
      mesh.add_quad(mesh.add_point(p), mesh.add_point(q), mesh.add_point(r), mesh.add_point(s));
    };
    for (auto i = 0u; i + 1 < radial.size(); ++i) {
      const auto in = radial[i], out = radial[i + 1];
      quad(at(a, in, y), at(a, out, y), at(b, out, y), at(b, in, y));
      quad(at(a, in, soffit(a)), at(b, in, soffit(b)), at(b, out, soffit(b)), at(a, out, soffit(a)));
    }
    // Sides: the left edge of a step's first piece ends where the last tread met it.
    for (const auto r : {radial.front(), radial.back()}) {
      const auto low_a = mesh.add_point(at(a, r, soffit(a)));
      const auto low_b = mesh.add_point(at(b, r, soffit(b)));
      const auto high_b = mesh.add_point(at(b, r, y));
      const auto high_a = mesh.add_point(at(a, r, y));
      const auto outwards = r > well;
      const auto triangle = [&](std::uint32_t p, std::uint32_t q, std::uint32_t s) {
        outwards ? mesh.add_triangle(p, q, s) : mesh.add_triangle(p, s, q);
      };
      triangle(low_b, high_b, high_a);
      if (piece == 0 && k > 0) {
        const auto notch = mesh.add_point(at(a, r, y - rise));
        triangle(low_b, high_a, notch);
        triangle(low_b, notch, low_a);
      } else {
        triangle(low_b, high_a, low_a);
      }
    }
  }
}

void add_riser(Mesh& mesh, int k) {
  const auto low = k == 0 ? soffit(0.0) : rise * k;
  const auto high = k == step_count ? low : rise * (k + 1);
  for (auto i = 0u; i + 1 < radial.size(); ++i) {
    const auto in = radial[i], out = radial[i + 1];
    mesh.add_quad(mesh.add_point(at(k, in, low)), mesh.add_point(at(k, out, low)),
                  mesh.add_point(at(k, out, high)), mesh.add_point(at(k, in, high)));
  }
}

Mesh flight() {
  auto mesh = Mesh{};
  for (auto k = 0; k < step_count; ++k) {
    add_step(mesh, k);
    add_riser(mesh, k);
  }
  for (auto i = 0u; i + 1 < radial.size(); ++i) {
    const auto in = radial[i], out = radial[i + 1];
    const auto low = soffit(step_count);
    mesh.add_quad(mesh.add_point(at(step_count, out, low)), mesh.add_point(at(step_count, in, low)),
                  mesh.add_point(at(step_count, in, landing)), mesh.add_point(at(step_count, out, landing)));
  }
  const auto is_tread = [](const Vec3d&, const Vec3d& n) { return n.y > 0.99; };
  return painted(painted(rounded(mesh), Paint::plaster_white), Paint::oak, is_tread);
}

// The half ring on which the flight ends.
Mesh landing_slab() {
  auto mesh = Mesh{};
  const auto from = step_count + 0.01, to = step_count + 10.0;
  constexpr auto cells = 20;
  const auto low = landing - 0.20;
  const auto quad = [&](const Vec3d& p, const Vec3d& q, const Vec3d& r, const Vec3d& s) {
    mesh.add_quad(mesh.add_point(p), mesh.add_point(q), mesh.add_point(r), mesh.add_point(s));
  };
  for (auto k = 0; k < cells; ++k) {
    const auto a = from + (to - from) * k / cells;
    const auto b = from + (to - from) * (k + 1) / cells;
    for (auto i = 0u; i + 1 < radial.size(); ++i) {
      const auto in = radial[i], out = radial[i + 1];
      quad(at(a, in, landing), at(a, out, landing), at(b, out, landing), at(b, in, landing));
      quad(at(a, in, low), at(b, in, low), at(b, out, low), at(a, out, low));
    }
    const auto in = radial.front(), out = radial.back();
    quad(at(a, in, low), at(a, in, landing), at(b, in, landing), at(b, in, low));
    quad(at(a, out, low), at(b, out, low), at(b, out, landing), at(a, out, landing));
  }
  for (auto i = 0u; i + 1 < radial.size(); ++i) {
    const auto in = radial[i], out = radial[i + 1];
    quad(at(from, in, low), at(from, out, low), at(from, out, landing), at(from, in, landing));
    quad(at(to, out, low), at(to, in, low), at(to, in, landing), at(to, out, landing));
  }
  return painted(painted(rounded(mesh), Paint::plaster_white), Paint::oak,
                 [](const Vec3d&, const Vec3d& n) { return n.y > 0.99; });
}

Mesh railing() {
  constexpr auto rail = well + 0.06;
  constexpr auto height = 0.92;
  auto path = std::vector<Vec3d>{};
  const auto last = step_count + 10.0;
  for (auto s = 0.3; s < last - 0.05; s += 0.5)
    path.push_back(at(s, rail, std::min(rise * (s + 0.9), landing) + height));
  auto mesh = painted(tube(path, 0.024, 10), Paint::walnut);
  auto bars = Mesh{};
  for (auto s = 0.30; s < last; s += 0.5) {
    const auto step = std::floor(s);
    const auto foot = s >= step_count ? landing : rise * (step + 1.0);
    const auto high = std::min(rise * (s + 0.9), landing) + height - 0.026;
    append(bars, tube({at(s, rail, foot + 0.001), at(s, rail, high)}, 0.009, 6));
  }
  // The newel post at the foot.
  append(mesh, painted(moved(cylinder(0.045, 1.06, 16), at(0.14, rail, rise + 0.001)), Paint::walnut));
  append(mesh, painted(moved(sphere(0.07, 18), at(0.14, rail, rise + 1.133)), Paint::brass));
  return joined({mesh, painted(bars, Paint::black_steel)});
}

void add_tower(MadeScene& scene) {
  auto floor = Mesh{};
  constexpr std::array rings = {0.0, 0.35, 0.45, 1.15, 1.25, 2.0, wall};
  for (auto i = 0u; i + 1 < rings.size(); ++i) {
    auto ring = turned_x(disc(rings[i + 1], rings[i], 0.0, 360.0, tower_segments), -90.0);
    ring = painted(ring, i % 2 == 1 ? Paint::terrazzo_2 : Paint::terrazzo_1);
    if (i == 2)
      ring = painted(ring, Paint::tile_green,
                     [](const Vec3d& p, const Vec3d&) { return std::sin(8.0 * std::atan2(p.z, p.x)) > 0.0; });
    append(floor, ring);
  }
  scene.add_open("floor", welded(floor));
  auto profile = Profile{};
  const auto levels = steps({0.0, top}, 0.55);
  for (auto k = levels.size(); k-- > 0;) profile.emplace_back(wall, levels[k]);
  auto walls = painted(lathe(profile, tower_segments), Paint::cream_wall);
  scene.add_open("walls", walls);
  // The dado climbs with the stairs: a band of wood along the wall.
  auto path = std::vector<Vec3d>{};
  for (auto s = 0.5; s < step_count + 9.6; s += 0.5)
    path.push_back(at(s, wall - 0.016, std::min(rise * (s + 0.9), landing) + 0.92));
  scene.add_closed("wall_rail", painted(tube(path, 0.014, 6), Paint::walnut));
  const auto ceiling =
      lathe({{wall, top}, {2.0, top}, {skylight, top}, {skylight, top + 0.35}}, tower_segments);
  scene.add_open("ceiling", painted(ceiling, Paint::plaster_white));
  scene.add_open("outside", painted(lathe({{0.0, -0.4},
                                           {wall + 0.4, -0.4},
                                           {wall + 0.4, 3.0},
                                           {wall + 0.4, 6.0},
                                           {wall + 0.4, 9.0},
                                           {wall + 0.4, top + 0.35},
                                           {skylight, top + 0.35}},
                                          tower_segments),
                                    Paint::brick));
  auto bars = Mesh{};
  for (auto k = 0; k < 6; ++k) {
    append(bars, turned_y(moved(box({skylight - 0.30, 0.06, 0.035}),
                                {0.15 + 0.5 * (skylight - 0.002), top + 0.20, 0.0}),
                          60.0 * k));
  }
  append(bars, lathe({{0.14, top + 0.19},
                      {0.18, top + 0.19},
                      {0.18, top + 0.27},
                      {0.14, top + 0.27},
                      {0.14, top + 0.19}},
                     24));
  scene.add_closed("skylight_bars", painted(welded(rounded(bars)), Paint::painted_wood));
}

// A globe on a bracket of brass, at the wall.
void add_lamps(MadeScene& scene) {
  auto brackets = Mesh{};
  auto globes = Mesh{};
  for (const auto step : {5.0, 16.0, 27.0, 38.0, 49.0, 60.0}) {
    const auto y = std::min(rise * step, landing) + 2.02;
    const auto middle = at(step, wall - 0.24, y);
    append(globes, moved(sphere(0.125, 22), middle));
    const auto foot = at(step, wall - 0.012, y - 0.22);
    append(brackets, tube(curve(foot, at(step, wall - 0.14, y - 0.24), at(step, wall - 0.24, y - 0.26),
                                middle - Vec3d(0.0, 0.128, 0.0), 8),
                          0.010, 8));
    append(brackets,
           moved(turned_y(turned_z(cylinder(0.045, 0.010, 16), 90.0), 360.0 * step / steps_per_turn),
                 at(step, wall - 0.001, y - 0.22)));
  }
  scene.add_closed("lamp_brackets", painted(brackets, Paint::brass));
  scene.add_closed("lamp_globes", painted(globes, Paint::lamp_stairs));
}

}  // namespace

MadeScene stairwell() {
  auto scene = MadeScene{.title = "A winding staircase round an open well, with wall lamps and a skylight",
                         .sky = "0.5,0.8,1.4"};
  add_tower(scene);
  scene.add_closed("flight", flight());
  scene.add_closed("landing", landing_slab());
  scene.add_closed("railing", railing());
  add_lamps(scene);
  scene.views = {
      {"down the well", at(step_count + 5.5, 0.95, landing + 1.55), at(step_count + 1.0, 0.45, 1.5), 72.0},
      {"up the well", {0.75, 0.9, 0.6}, {-0.1, 9.0, -0.1}, 75.0}};
  return scene;
}

}  // namespace luxel::scenes
