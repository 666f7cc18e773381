// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "luxel/lamps/direct_light.h"
#include "luxel/patch/make_patches.h"
#include "luxel/patch/side.h"
#include "luxel/photometry/photometry.h"
#include "luxel/scene/luminous_efficacy.h"
#include "luxel/solve/sampled.h"

#include "bench/mesher.h"
#include "bench/sections.h"
#include "bench/timing.h"

namespace luxel::bench {
namespace {

constexpr Vec3 hall{40.0f, 20.0f, 3.0f};      // m, z up
constexpr float side = 0.6f, hanging = 2.8f;  // of a lamp, and its height, m
constexpr int columns = 20, rows = 10;        // of lamps: 200
constexpr double flux = 4000.0;               // lm of each lamp

// 145 planes of 37 angles, all different, below the horizontal: nearly a cosine, to be like a square lamp.
std::shared_ptr<const Photometry> file_of_145_planes() {
  std::vector<double> gamma, around, candela;
  for (int i = 0; i < 37; ++i) gamma.push_back(2.5 * i);
  for (int j = 0; j < 145; ++j) around.push_back(2.5 * j);
  for (const auto c : around)
    for (const auto g : gamma) {
      const auto radians = std::numbers::pi / 180.0;
      candela.push_back(std::max(0.0, std::cos(g * radians)) *
                        (1.0 + 0.05 * std::sin(c * radians) * std::sin(2.0 * g * radians)));
    }
  const IntensityDistribution unit(GoniometerType::c, gamma, around, candela);
  for (auto& value : candela) value *= flux / unit.linear_flux();
  auto photometry = std::make_shared<Photometry>();
  photometry->file = "bench.ies";
  photometry->intensity = {GoniometerType::c, gamma, around, candela};
  photometry->opening = {OpeningShape::rectangle, Vec3d(double{side}, double{side}, 0.0)};
  return photometry;
}

Vec3 place_of_lamp(int i) {
  const auto column = static_cast<float>(i % columns), row = static_cast<float>(i / columns);
  return {(column + 0.5f) * hall.x / columns, (row + 0.5f) * hall.y / rows, hanging};
}

// A hall with a table below each of the 200 lamps.
Scene hall_with(bool has_luminaires) {
  Mesher mesher;
  mesher.material("hall", Vec3(0.5f));
  mesher.box(Vec3(0.0f), hall, true);
  mesher.material("tables", Vec3(0.4f));
  for (int i = 0; i < columns * rows; ++i) {
    const auto at = place_of_lamp(i);
    mesher.box({at.x - 0.4f, at.y - 0.7f, 0.68f}, {at.x + 0.4f, at.y + 0.7f, 0.72f});
  }
  if (!has_luminaires) {
    mesher.material("lamps", Vec3(0.0f), Vec3(static_cast<float>(flux / luminous_efficacy) / (side * side)));
    const auto h = 0.5f * side;
    for (int i = 0; i < columns * rows; ++i) {
      const auto p = place_of_lamp(i);
      mesher.whole_quad({p.x - h, p.y + h, p.z}, {p.x + h, p.y + h, p.z}, {p.x + h, p.y - h, p.z},
                        {p.x - h, p.y - h, p.z});
    }
  }
  auto scene = mesher.take();
  if (has_luminaires) {
    const auto photometry = file_of_145_planes();
    for (int i = 0; i < columns * rows; ++i) {
      PointLight light;
      light.name = "luminaire";
      light.kind = PointLightKind::luminaire;
      light.position = place_of_lamp(i);
      light.direction = {0, 0, -1};
      light.local_y = {0, 1, 0};
      light.intensity = Vec3(static_cast<float>(photometry->intensity.maximum() / luminous_efficacy));
      light.photometry = photometry;
      scene.point_lights.push_back(light);
    }
  }
  return scene;
}

// One of the two halls, ready to be measured on one thread.
class Hall {
 public:
  Hall(bool has_luminaires, float edge)
      : patches_(make_patches(hall_with(has_luminaires), {.max_edge = edge, .contacts = false})),
        context_(1),
        tracer_(patches_, context_),
        lamps_(patches_),
        direct_(patches_, tracer_, lamps_, {}) {}
  Hall(const Hall&) = delete;
  Hall& operator=(const Hall&) = delete;

  // ns of processor time per shadow ray towards lamps, all sides that are no lamp.
  double shadow_rays(std::uint32_t per_replicate) const {
    const DirectOptions options;
    std::vector<float> out(options.replicates * patches_.band_count());
    std::uint64_t rays = 0;
    const auto spent = cost([&] {
      for (std::size_t p = 0; p < patches_.size(); ++p)
        if (patches_.material_of(p).name != "lamps")
          rays += direct_.estimate(SideId(p, false), static_cast<std::uint32_t>(p), 0, per_replicate, out);
    });
    return 1e9 * spent.cpu / static_cast<double>(rays);
  }
  // The same per ray of a whole solve. lumens: what all sides receive, for comparison.
  double solve(std::uint64_t rays, double& lumens) const {
    Solution solution;
    SolveReport report;
    const auto spent = cost([&] {
      report = solve_sampled(patches_, tracer_, solution,
                             {.error = 0.0, .error_measure = ErrorMeasure::power, .rays = rays}, context_);
    });
    lumens = luminous_efficacy * report.means.received.power[0];
    return 1e9 * spent.cpu / static_cast<double>(report.rays);
  }
  std::size_t patches() const { return patches_.size(); }

 private:
  PatchSet patches_;
  Context context_;
  Tracer tracer_;
  Lamps lamps_;
  DirectLight direct_;
};

// Alternating pairs of A and B, like paired(), but with the numbers that the bodies return.
template <typename A, typename B>
Json pairs_of(const char* what, int pairs, A luminaires, B squares) {
  std::vector<double> ratios, of_luminaires, of_squares;
  for (int i = 0; i < pairs; ++i) {
    of_luminaires.push_back(luminaires());
    of_squares.push_back(squares());
    ratios.push_back(of_luminaires.back() / of_squares.back());
  }
  const auto [low, high] = std::minmax_element(ratios.begin(), ratios.end());
  fmt::print("{:>28} {:>12.0f} {:>12.0f} {:>8.2f} {:>8.2f} to {:.2f}\n", what, median(of_luminaires),
             median(of_squares), median(ratios), *low, *high);
  return {{"what", what},
          {"luminaires_ns", median(of_luminaires)},
          {"square_lamps_ns", median(of_squares)},
          {"ratio", median(ratios)},
          {"ratio_low", *low},
          {"ratio_high", *high}};
}

}  // namespace

Json luminaires_against_lamps(const Settings& settings) {
  fmt::print(
      "\nluminaires: 200 luminaires of 145 x 37 intensities against 200 square lamps of the same flux\n");
  fmt::print("{:>28} {:>12} {:>12} {:>8} {:>17}\n", "processor time per ray", "luminaires", "squares",
             "ratio", "(low to high)");
  const auto edge = settings.small ? 4.0f : 0.5f;
  const Hall luminaires(true, edge), squares(false, edge);
  const auto pairs = settings.small ? 1 : 7;
  Json rows_of_table = Json::array();
  for (const std::uint32_t samples : {1u, 4u, 16u}) {
    const auto what = fmt::format("shadow rays, {} per side", 8 * samples);
    rows_of_table.push_back(pairs_of(
        what.c_str(), pairs, [&] { return luminaires.shadow_rays(samples); },
        [&] { return squares.shadow_rays(samples); }));
  }
  const std::uint64_t rays = settings.small ? 20'000 : 4'000'000;
  double lit = 0.0, by_squares = 0.0;
  rows_of_table.push_back(pairs_of(
      "whole solve", pairs, [&] { return luminaires.solve(rays, lit); },
      [&] { return squares.solve(rays, by_squares); }));
  fmt::print("{} patches; {:.0f} and {:.0f} lm received\n", luminaires.patches(), lit, by_squares);
  return rows_of_table;
}

}  // namespace luxel::bench
