// SPDX-License-Identifier: Apache-2.0
// Sheets, lamps right under ceilings, surfaces on top of each other and closed boxes: cases in which light is
// known without solving, at three scales and far from zero. Means over runs of other seeds carry the standard
// error of their own spread; with 6 runs, 15 of those (Student's t) are exceeded once in forty thousand
// times.
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "luxel/classical/stochastic_jacobi.h"
#include "luxel/form_factors/polygon_form_factor.h"
#include "luxel/patch/make_patches.h"
#include "luxel/render/path_traced.h"
#include "luxel/solve/sampled.h"

#include "support/scene_files.h"
#include "support/truth_scenes.h"

namespace luxel {
namespace {

using truth::SceneBuilder;

constexpr float half = 2.0f, height = 2.5f;  // m, of the room: x and y from -half to half
constexpr float light = 100.0f;              // W/m² of a lamp
constexpr float millimetre = 0x1p-10f;       // m; as powers of two every scale and place has the same bits
constexpr float tenth = 0x1p-13f;            // of a millimetre
constexpr int runs = 8;
constexpr double max_errors = 15.0;

// x and y from low to high at height z, front down.
SceneBuilder& add_ceiling(SceneBuilder& b, const Vec2& low, const Vec2& high, float z) {
  return b.quad({low.x, high.y, z}, {high.x, high.y, z}, {high.x, low.y, z}, {low.x, low.y, z});
}

// A closed room, its front inside; the ceiling apart, around `gap` by `gap` metres in its midst.
SceneBuilder room(float rho, float gap = 0.0f) {
  constexpr float a = half, h = height;
  SceneBuilder b;
  b.material("floor", rho, 0.0f).quad({-a, -a, 0}, {a, -a, 0}, {a, a, 0}, {-a, a, 0});
  b.material("walls", rho, 0.0f);
  b.quad({-a, -a, 0}, {-a, a, 0}, {-a, a, h}, {-a, -a, h}).quad({a, a, 0}, {a, -a, 0}, {a, -a, h}, {a, a, h});
  b.quad({a, -a, 0}, {-a, -a, 0}, {-a, -a, h}, {a, -a, h}).quad({-a, a, 0}, {a, a, 0}, {a, a, h}, {-a, a, h});
  b.material("ceiling", rho, 0.0f);
  const float g = 0.5f * gap;
  add_ceiling(b, {-a, -a}, {a, -g}, h);
  add_ceiling(b, {-a, g}, {a, a}, h);
  if (gap > 0.0f) {
    add_ceiling(b, {-a, -g}, {-g, g}, h);
    add_ceiling(b, {g, -g}, {a, g}, h);
  }
  return b;
}

void add_lamp(SceneBuilder& b, float rho, const Vec2& low, const Vec2& high, float z) {
  add_ceiling(b.material("lamp", rho, light), low, high, z);
}

std::vector<Vec3d> down(const Vec2& low, const Vec2& high, float z) {
  return {{low.x, high.y, z}, {high.x, high.y, z}, {high.x, low.y, z}, {low.x, low.y, z}};
}

// Six faces of a cube with an edge of one metre, each corner of each face a vertex of its own; turned so that
// its diagonal lies along x, with the corner at `tip` foremost.
void add_box(SceneBuilder& b, float rho, const Vec3& tip) {
  const Vec3d x(1.0 / std::sqrt(3.0)), y(glm::normalize(Vec3d(1.0, -1.0, 0.0))), z(glm::cross(x, y));
  const auto corner = [&](int i) {
    const Vec3d c((i & 1) - 1.0, (i >> 1 & 1) - 1.0, (i >> 2 & 1) - 1.0);  // the tip is i = 7, at 0
    return tip + Vec3(Vec3d(glm::dot(c, x), glm::dot(c, y), glm::dot(c, z)));
  };
  constexpr int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                               {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  b.material("box", rho, 0.0f);
  for (const auto& f : faces) b.quad(corner(f[0]), corner(f[1]), corner(f[2]), corner(f[3]));
}

enum class By { sampling, shooting, paths };
constexpr By all_ways[] = {By::sampling, By::shooting, By::paths};

struct Lit {
  PatchSet patches;
  Solution light;
  EnergyBalance energy;  // not of paths
};

// unit: factor on all requested lengths, metres per metre.
Lit solve(const Scene& scene, By by, std::uint64_t seed = 1, float max_edge = 2.0f, float unit = 1.0f) {
  Lit lit;
  const Context context;
  lit.patches =
      make_patches(scene, {.max_edge = unit * max_edge, .contact_gap = unit * PatchOptions().contact_gap});
  const Tracer tracer(lit.patches, context);
  auto& [patches, solution, energy] = lit;
  if (by == By::sampling)
    energy = solve_sampled(patches, tracer, solution,
                           {.error = 0.02, .error_measure = ErrorMeasure::power, .seed = seed}, context)
                 .energy;
  if (by == By::shooting)
    energy =
        solve_stochastic_jacobi(patches, tracer, solution, {.rays = 100'000, .seed = seed}, context).energy;
  if (by == By::paths)
    trace_light(patches, tracer, solution,
                {.limits = {.samples = 384}, .bounces_from = BouncesFrom::patches, .seed = seed}, context);
  return lit;
}

// Runs of different seeds.
std::vector<Lit> solve_often(const Scene& scene, By by) {
  std::vector<Lit> all;
  for (std::uint64_t seed = 1; seed <= runs; ++seed) all.push_back(solve(scene, by, seed));
  return all;
}

struct Mean {
  double value = 0.0, error = 0.0;
};

template <typename Number>
Mean mean_of(const std::vector<Lit>& all, const Number& number) {
  double sum = 0.0, squares = 0.0;
  for (const auto& lit : all) {
    const double x = number(lit);
    sum += x;
    squares += x * x;
  }
  const auto mean = sum / runs;
  return {mean, std::sqrt(std::max(0.0, squares / runs - mean * mean) / (runs - 1))};
}

double front(const Lit& lit, const char* material) {
  return truth::mean_irradiance(lit.patches, lit.light.irradiance.front, material);
}
Mean front(const std::vector<Lit>& all, const char* material) {
  return mean_of(all, [&](const Lit& lit) { return front(lit, material); });
}
Mean back(const std::vector<Lit>& all, const char* material) {
  return mean_of(all, [&](const Lit& lit) {
    return truth::mean_irradiance(lit.patches, lit.light.irradiance.back, material);
  });
}

// The sampled method takes the mean of unshadowed light over a patch from few points, see find_side_lamps().
constexpr double few_points = 1e-3;
void expect_near(const Mean& found, double truth) {
  EXPECT_NEAR(found.value, truth, max_errors * found.error + few_points * truth);
  EXPECT_LT(found.error, 0.01 * truth) << "too noisy to tell";
}

// A lamp before each side of a sheet that stands in the midst of a black room.
constexpr float sheet_area = 2.0f;  // m²
Scene sheet(bool two_sided) {
  auto b = room(0.0f);
  add_lamp(b, 0.0f, {0.5f, -0.5f}, {1.0f, 0.5f}, 2.0f);
  add_ceiling(b, {-1.0f, -0.5f}, {-0.5f, 0.5f}, 2.0f);
  b.material("sheet", 0.5f, 0.0f, two_sided);
  b.quad({0, -1, 0.5f}, {0, 1, 0.5f}, {0, 1, 1.5f}, {0, -1, 1.5f});
  return b.scene();
}

TEST(ThinThings, a_sheet_is_lit_on_each_side_as_if_the_other_were_not_there) {
  const auto lamp = down({0.5f, -0.5f}, {1.0f, 0.5f}, 2.0f);
  const std::vector<Vec3d> plate = {{0, -1, 0.5}, {0, 1, 0.5}, {0, 1, 1.5}, {0, -1, 1.5}};
  const auto truth = light * polygon_exchange_area(lamp, plate) / sheet_area;
  for (const auto by : all_ways) {
    SCOPED_TRACE(static_cast<int>(by));
    const auto both = solve_often(sheet(true), by);
    expect_near(front(both, "sheet"), truth);
    expect_near(back(both, "sheet"), truth);
    const auto one = solve_often(sheet(false), by);
    expect_near(front(one, "sheet"), truth);
    EXPECT_EQ(back(one, "sheet").value, 0.0);
    if (by == By::paths) continue;
    expect_near(mean_of(one, [](const Lit& l) { return l.energy.lost_at_backs[0] / sheet_area; }), truth);
  }
}

// A lamp a millimetre below a ceiling, the part above it a material of its own.
Scene lamp_under_ceiling(float rho) {
  constexpr float g = 0.25f;
  auto b = room(rho, 2.0f * g);
  add_ceiling(b.material("above", rho, 0.0f), Vec2(-g), Vec2(g), height);
  add_lamp(b, rho, Vec2(-g), Vec2(g), height - millimetre);
  return b.scene();
}

TEST(ThinThings, a_lamp_a_millimetre_under_a_black_ceiling_lights_the_floor_alone) {
  const std::vector<Vec3d> floor = {{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}};
  const auto lamp = down(Vec2(-0.25f), Vec2(0.25f), height - millimetre);
  const auto truth = light * polygon_exchange_area(lamp, floor) / (4.0 * half * half);
  for (const auto by : all_ways) {
    SCOPED_TRACE(static_cast<int>(by));
    const auto all = solve_often(lamp_under_ceiling(0.0f), by);
    expect_near(front(all, "floor"), truth);
    EXPECT_EQ(front(all, "above").value, 0.0);
    EXPECT_EQ(front(all, "ceiling").value, 0.0);
  }
}

// Between two squares of half a metre a millimetre apart, 0.6 % of the light comes from outside, doubled by
// bounces between them.
TEST(ThinThings, the_ceiling_above_a_lamp_stays_dark_but_for_bounces) {
  std::vector<Mean> above;
  for (const auto by : all_ways) {
    const auto all = solve_often(lamp_under_ceiling(0.5f), by);
    above.push_back(front(all, "above"));
    EXPECT_LT(above.back().value, 0.02 * front(all, "ceiling").value) << static_cast<int>(by);
    EXPECT_GT(above.back().value, 0.0) << static_cast<int>(by);
  }
  const auto& truth = above.back();  // of paths
  for (const auto& found : above)
    EXPECT_NEAR(found.value, truth.value, max_errors * std::hypot(found.error, truth.error));
}

enum class Pile { once, twice, other_diagonal, overlap, opposite };

// A table of 2 m by 2 m, or surfaces that cover the same square in more than one layer.
Scene table(Pile pile) {
  auto b = room(0.5f);
  add_lamp(b, 0.5f, Vec2(-0.5f), Vec2(0.5f), 2.25f);
  b.material("table", 0.75f, 0.0f);
  const float z = 0.75f;
  const auto strip = [&](float x0, float x1) { b.quad({x0, -1, z}, {x1, -1, z}, {x1, 1, z}, {x0, 1, z}); };
  strip(-1, pile == Pile::overlap ? 0.5f : 1.0f);
  if (pile == Pile::twice) strip(-1, 1);
  if (pile == Pile::overlap) strip(-0.5f, 1);
  if (pile == Pile::other_diagonal) b.quad({1, -1, z}, {1, 1, z}, {-1, 1, z}, {-1, -1, z});
  if (pile == Pile::opposite) b.quad({1, -1, z}, {-1, -1, z}, {-1, 1, z}, {1, 1, z});
  return b.scene();
}

TEST(ThinThings, surfaces_on_top_of_each_other_give_the_light_of_one) {
  for (const auto by : {By::sampling, By::shooting}) {
    const auto once = solve_often(table(Pile::once), by);
    EXPECT_EQ(once[0].light.irradiance.front, solve(table(Pile::twice), by).light.irradiance.front);
    for (const auto pile : {Pile::other_diagonal, Pile::overlap, Pile::opposite}) {
      const auto all = solve_often(table(pile), by);
      for (const auto* material : {"floor", "walls", "ceiling"}) {
        const auto a = front(once, material), b = front(all, material);
        EXPECT_NEAR(a.value, b.value, max_errors * std::hypot(a.error, b.error))
            << static_cast<int>(by) << ' ' << static_cast<int>(pile) << ' ' << material;
        EXPECT_LT(std::hypot(a.error, b.error), 0.003 * a.value) << "too noisy to tell";
      }
    }
  }
}

TEST(ThinThings, surfaces_on_top_of_each_other_absorb_the_light_of_one) {
  for (const auto pile : {Pile::other_diagonal, Pile::overlap, Pile::opposite}) {
    const auto taken_up = mean_of(solve_often(table(pile), By::sampling), [](const Lit& l) {
      return (l.energy.absorbed[0] + l.energy.escaped[0]) / l.energy.emitted[0];
    });
    expect_near(taken_up, 1.0);
  }
}

// A lit room with a closed box: in its midst, or with a corner through the wall.
Scene box_at(const Vec3& tip) {
  auto b = room(0.5f);
  add_lamp(b, 0.5f, {-1.5f, -0.5f}, {-0.5f, 0.5f}, 2.25f);
  add_box(b, 0.8f, tip);
  return b.scene();
}
const Vec3 midst(0.75f, 0.125f, 1.0f);
const Vec3 through_the_wall(half + tenth, 0.125f, 1.0f);

TEST(ThinThings, a_closed_box_in_a_lit_room_is_black_inside) {
  for (const auto by : all_ways) {
    const auto lit = solve(box_at(midst), by, 1, 0.5f);
    for (std::size_t p = 0; p < lit.patches.size(); ++p) {
      if (lit.patches.material_of(p).name != "box") continue;
      EXPECT_EQ(lit.light.irradiance.back[3 * p], 0.0f) << static_cast<int>(by) << ": patch " << p;
      EXPECT_GT(lit.light.irradiance.front[3 * p], 0.0f);
    }
  }
}

// The part of the wall inside the box is a triangle of 3 sqrt(3) / 2 times the square of how far the corner
// stands out. At most its light, reflected on and on, is inside.
TEST(ThinThings, a_corner_through_a_wall_lets_in_no_more_than_the_hole_it_makes) {
  const double hole = 1.5 * std::sqrt(3.0) * tenth * tenth;  // m²
  for (const auto by : all_ways) {
    const auto lit = solve(box_at(through_the_wall), by, 1, 0.5f);
    double brightest = 0.0, inside = 0.0;
    for (std::size_t p = 0; p < lit.patches.size(); ++p) {
      const auto& name = lit.patches.material_of(p).name;
      if (name == "walls")
        brightest = std::max(brightest, static_cast<double>(lit.light.radiosity.front[3 * p]));
      if (name == "box")
        inside +=
            static_cast<double>(lit.patches.area[p]) * static_cast<double>(lit.light.irradiance.back[3 * p]);
    }
    EXPECT_GT(brightest, 0.0);
    EXPECT_LE(inside, hole * brightest / (1.0 - 0.8)) << static_cast<int>(by);
  }
}

std::vector<Scene> all_scenes() {
  return {sheet(false), lamp_under_ceiling(0.5f), table(Pile::overlap), box_at(through_the_wall)};
}

void expect_same_light(const Lit& a, const Lit& b) {
  EXPECT_EQ(a.light.irradiance.front, b.light.irradiance.front);
  EXPECT_EQ(a.light.irradiance.back, b.light.irradiance.back);
}

TEST(ThinThings, light_is_the_same_in_millimetres_and_in_kilometres) {
  for (const auto& scene : all_scenes())
    for (const auto by : all_ways) {
      const auto as_it_is = solve(scene, by);
      for (const float scale : {0x1p-10f, 0x1p10f}) {
        auto scaled = scene;
        for (auto& p : scaled.positions) p *= scale;
        expect_same_light(as_it_is, solve(scaled, by, 1, 2.0f, scale));
      }
    }
}

// As a file with its corner of the world at `place`.
std::string as_obj(const Scene& scene, const Vec3d& place) {
  std::string text = "mtllib room.mtl\n";
  for (const auto& p : scene.positions)
    text += fmt::format("v {:.16f} {:.16f} {:.16f}\n", place.x + p.x, place.y + p.y, place.z + p.z);
  for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
    const auto& t = scene.triangles[i];
    text += fmt::format("usemtl {}\nf {} {} {}\n",
                        scene.materials[static_cast<std::size_t>(scene.triangle_material[i])].name, t[0] + 1,
                        t[1] + 1, t[2] + 1);
  }
  return text;
}
std::string as_mtl(const Scene& scene) {
  std::string text;
  for (const auto& m : scene.materials)
    text += fmt::format("newmtl {}\nKd {} {} {}\nKe {} {} {}\n", m.name, m.reflectance.r, m.reflectance.g,
                        m.reflectance.b, m.emittance.r / pi, m.emittance.g / pi, m.emittance.b / pi);
  return text;
}

TEST(ThinThings, light_is_the_same_a_thousand_kilometres_from_zero) {
  SceneFiles files;
  const Vec3d far(100'000.0, -1'000'000.0, 800.0);
  for (const auto& scene : all_scenes()) {
    files.write("room.mtl", as_mtl(scene));
    const auto here = files.load_text(as_obj(scene, Vec3d(0.0)));
    const auto there = files.load_text(as_obj(scene, far));
    EXPECT_EQ(here.origin, Vec3d(0.0));
    EXPECT_EQ(there.origin, far);
    for (const auto by : all_ways) expect_same_light(solve(here, by), solve(there, by));
  }
}

}  // namespace
}  // namespace luxel
