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
#include "support/reference_light.h"

namespace luxel {
namespace {

using test::expect_same_light;
using test::solved;
using test::total;
using truth::glazed_room;
using truth::Glazing;
using truth::parted_room;
using truth::with_portals;

const Vec3 tint(0.5f, 0.7f, 0.9f);

TEST(GlassEnergy, a_glazed_room_has_the_light_of_the_reference) {
  for (const bool portals : {false, true})
    for (const auto& transmittance : {Vec3(0.7f), tint}) {
      SCOPED_TRACE(portals);
      const auto energy =
          expect_same_light(with_portals(glazed_room(Glazing::sheet, transmittance, 0.6f), portals));
      EXPECT_GT(total(energy.in_panes), 0.0);
    }
}

TEST(GlassEnergy, a_room_parted_by_glass_has_the_light_of_the_reference) {
  const auto energy = expect_same_light(make_patches(parted_room(Vec3(0.6f)), {.max_edge = 0.4f}));
  EXPECT_GT(total(energy.in_panes), 0.0);
}

// Rays to surfaces carry all bands alike: light through tinted glass has the glass's brightness, not its
// tint.
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
