// SPDX-License-Identifier: Apache-2.0
// Rooms with panes of glass against the path-traced reference, and their energy balance.
//
// Risk. Seeds are fixed. With other random numbers one of the some hundred comparisons would be six of its
// standard errors off (widened by Student's t) with a chance of one in ten thousand.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/patch/make_patches.h"
#include "luxel/render/path_traced.h"
#include "luxel/solve/sampled.h"
#include "luxel/solve/solve_light.h"

#include "support/glass_panes.h"

namespace luxel {
namespace {

using truth::glazed_room;
using truth::Glazing;
using truth::parted_room;
using truth::with_portals;

constexpr double sigmas = 6.0;
const Vec3 tint(0.5f, 0.7f, 0.9f);

Solution solved(const PatchSet& patches, EnergyBalance& energy, SurfaceMeans& means) {
  const Context context(2);
  const Tracer tracer(patches, context);
  Solution light;
  auto report =
      solve_sampled(patches, tracer, light,
                    {.error = 0.01, .error_measure = ErrorMeasure::power, .smoothing = false}, context);
  energy = report.energy;
  means = report.means;
  return light;
}

double total(const std::vector<double>& bands) {
  double sum = 0.0;
  for (const auto b : bands) sum += b;
  return sum;
}

// Means of materials by both, band by band, and the parts of the energy balance.
void expect_same_light(const PatchSet& patches, double tolerance = 0.0) {
  const Context context(2);
  const Tracer tracer(patches, context);
  EnergyBalance energy;
  SurfaceMeans means;
  solved(patches, energy, means);
  Solution reference;
  const auto traced =
      trace_light(patches, tracer, reference,
                  {.limits = {.error = 0.01}, .bounces_from = BouncesFrom::patches, .seed = 5}, context);
  std::size_t compared = 0;
  for (const auto& mean : means.surfaces)
    for (std::size_t b = 0; b < 3; ++b) {
      double area = 0.0, truth = 0.0, variance = 0.0;
      for (std::size_t p = 0; p < patches.size(); ++p) {
        if (static_cast<std::size_t>(patches.material[p]) != mean.material) continue;
        const double a = patches.area[p];
        const auto i = 3 * p + b;
        area += a;
        truth += a * static_cast<double>(reference.irradiance.of(mean.is_back)[i]);
        variance += std::pow(a * static_cast<double>(reference.standard_error.of(mean.is_back)[i]), 2.0);
      }
      EXPECT_NEAR(mean.irradiance[b], truth / area,
                  sigmas * std::hypot(mean.standard_error[b], std::sqrt(variance) / area) +
                      (2e-3 + tolerance) * truth / area)
          << mean.name << (mean.is_back ? " back" : "") << ", band " << b;
      ++compared;
    }
  EXPECT_GE(compared, 6u);
  const auto whole = total(energy.emitted) + total(energy.from_sky);
  const auto near = [&](const std::vector<double>& a, const std::vector<double>& b, const char* what) {
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(a[i], b[i], (0.02 + tolerance) * whole / 3.0) << what << i;
  };
  near(energy.from_sky, traced.from_sky, "from sky");
  near(energy.absorbed, traced.absorbed, "absorbed");
  near(energy.escaped, traced.escaped, "escaped");
  near(energy.in_panes, traced.in_panes, "in panes");
  const auto gone =
      total(energy.absorbed) + total(energy.escaped) + total(energy.lost_at_backs) + total(energy.in_panes);
  EXPECT_NEAR(gone, whole, 0.02 * whole);
  EXPECT_GT(total(energy.in_panes), 0.0);
}

TEST(GlassEnergy, a_glazed_room_has_the_light_of_the_reference) {
  for (const bool portals : {false, true})
    for (const auto& transmittance : {Vec3(0.7f), tint}) {
      SCOPED_TRACE(portals);
      expect_same_light(with_portals(glazed_room(Glazing::sheet, transmittance, 0.6f), portals));
    }
}

TEST(GlassEnergy, a_room_parted_by_glass_has_the_light_of_the_reference) {
  expect_same_light(make_patches(parted_room(Vec3(0.6f)), {.max_edge = 0.4f}));
}

// Rays to surfaces carry all bands alike: what is seen through tinted glass has its brightness, not its tint.
TEST(GlassEnergy, surfaces_behind_tinted_glass_keep_their_luminance) {
  const auto patches = make_patches(parted_room(Vec3(0.5f, 0.62f, 0.55f)), {.max_edge = 0.4f});
  EnergyBalance energy;
  SurfaceMeans means;
  solved(patches, energy, means);
  const Context context(2);
  const Tracer tracer(patches, context);
  Solution reference;
  trace_light(patches, tracer, reference, {.limits = {.error = 0.01}, .bounces_from = BouncesFrom::patches},
              context);
  constexpr std::array<double, 3> weight = {0.2126, 0.7152, 0.0722};
  for (const auto& mean : means.surfaces) {
    if (mean.is_back) continue;
    double area = 0.0, truth = 0.0, found = 0.0;
    for (std::size_t p = 0; p < patches.size(); ++p) {
      if (static_cast<std::size_t>(patches.material[p]) != mean.material) continue;
      area += static_cast<double>(patches.area[p]);
      for (std::size_t b = 0; b < 3; ++b)
        truth += weight[b] * static_cast<double>(patches.area[p]) *
                 static_cast<double>(reference.irradiance.front[3 * p + b]);
    }
    for (std::size_t b = 0; b < 3; ++b) found += weight[b] * mean.irradiance[b];
    EXPECT_NEAR(found, truth / area, 0.015 * truth / area) << mean.name;
  }
}

// A furnace: every surface emits 1 - reflectance. Without glass all radiosities are 1; glass takes a part,
// and the balance adds up.
TEST(GlassEnergy, a_furnace_with_glass_loses_in_it_what_it_emits_and_does_not_absorb) {
  auto scene = truth::furnace(Vec3(0.8f), Vec3(0.5f));
  const auto without = make_patches(scene, {.max_edge = 0.3f});
  EnergyBalance energy;
  SurfaceMeans means;
  solved(without, energy, means);
  EXPECT_NEAR(total(energy.absorbed), total(energy.emitted), 1e-3 * total(energy.emitted));
  EXPECT_EQ(total(energy.in_panes), 0.0);

  const auto glass = static_cast<MaterialId>(scene.materials.size());
  Material material{.name = "glass"};
  material.opaque = false;
  material.transmittance = Vec3(0.5f);
  scene.materials.push_back(material);
  const auto box = bounds(scene);
  const auto low = box.low, high = box.high;
  const auto x = 0.25f * low.x + 0.75f * high.x;
  const auto first = static_cast<std::uint32_t>(scene.positions.size());
  for (const auto& p :
       {Vec3(x, low.y, low.z), Vec3(x, high.y, low.z), Vec3(x, high.y, high.z), Vec3(x, low.y, high.z)})
    scene.positions.push_back(p);
  for (const auto& t : {std::array{first, first + 1, first + 2}, std::array{first, first + 2, first + 3}}) {
    scene.triangles.push_back(t);
    scene.triangle_material.push_back(glass);
    scene.triangle_line.push_back(0);
    scene.triangle_group.push_back(0);
  }
  const auto with = make_patches(scene, {.max_edge = 0.3f});
  EXPECT_EQ(with.panes.size(), 2u);
  solved(with, energy, means);
  const auto emitted = total(energy.emitted);
  EXPECT_GT(total(energy.in_panes), 0.1 * emitted);
  EXPECT_NEAR(total(energy.absorbed) + total(energy.in_panes), emitted, 0.01 * emitted);
  EXPECT_EQ(total(energy.escaped), 0.0);
}

TEST(GlassEnergy, methods_that_know_surfaces_alone_refuse_it) {
  const auto patches = make_patches(parted_room(Vec3(0.6f)), {.max_edge = 0.5f});
  const Context context(2);
  const Tracer tracer(patches, context);
  for (const auto method : {Method::shooting, Method::dense, Method::hemicube, Method::lines}) {
    LightOptions options;
    options.method = method;
    Solution light;
    try {
      solve_light(patches, tracer, light, options, {}, context);
      ADD_FAILURE() << name(method) << " solved it";
    } catch (const InputError& error) {
      EXPECT_EQ(
          std::string(error.what()),
          "this method does not know glass that absorbs light, as 'glass' does; solve it by the sampled "
          "method or by luxel reference");
    }
  }
}

}  // namespace
}  // namespace luxel
