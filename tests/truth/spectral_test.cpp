// SPDX-License-Identifier: Apache-2.0
// Light by wavelength that is known: of closed rooms whose surfaces are all alike, B = E / (1 - rho) at each
// wavelength, and its colour by an integral that the solver does not use.
#include <array>
#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "luxel/classical/classical.h"
#include "luxel/core/error.h"
#include "luxel/patch/make_patches.h"
#include "luxel/render/compare.h"
#include "luxel/render/final_gather.h"
#include "luxel/render/path_picture.h"
#include "luxel/render/render.h"
#include "luxel/scene/colour_spectra.h"
#include "luxel/scene/observer.h"
#include "luxel/solve/sampled.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

const Camera inside = {.eye = {0.1f, 0.15f, 0.2f}, .target = {0.9f, 0.8f, 0.6f}, .up = {0.0f, 0.0f, 1.0f}};

std::vector<double> wavelengths(double step, double first = 400.0, double last = 700.0) {
  std::vector<double> result;
  for (double w = first; w <= last; w += step) result.push_back(w);
  return result;
}

// A reddish paint, and a lamp whose light is of all colours but uneven.
const Spectrum paint({{400.0, 0.1}, {500.0, 0.15}, {560.0, 0.2}, {620.0, 0.75}, {700.0, 0.8}});
const Spectrum lamp({{400.0, 0.002}, {480.0, 0.01}, {530.0, 0.004}, {610.0, 0.02}, {700.0, 0.005}});

// A cube of one paint that glows all over.
Scene glowing_cube(const Spectrum& reflects, const Spectrum& emits, double step) {
  auto scene = truth::cube({});
  for (auto& material : scene.materials) {
    material.reflectance_spectrum = reflects;
    material.emittance_spectrum = emits;
  }
  scene.wavelengths = wavelengths(step);
  return scene;
}

// Linear sRGB of a spectrum, W/m² nm, by a fine sum of its own.
template <typename Of>
Vec3d fine_colour(const Of& of) {
  constexpr double step = 0.01;
  const auto& eye = cie_1931_observer();
  Vec3d xyz(0.0);
  for (double w = 400.0 + 0.5 * step; w < 700.0; w += step)
    xyz +=
        step * of(w) * Vec3d(eye.x.at(w, Beyond::zero), eye.y.at(w, Beyond::zero), eye.z.at(w, Beyond::zero));
  const glm::dmat3 rgb_of_xyz = {
      {3.2406, -0.9689, 0.0557}, {-1.5372, 1.8758, -0.2040}, {-0.4986, 0.0415, 1.0570}};
  return rgb_of_xyz * xyz * (683.0 / 179.0);
}

Vec3d colour_of_patch(const Baked& baked, std::size_t patch) {
  return baked.patches.colours().rgb(&baked.solution.radiosity.front[patch * baked.patches.band_count()]);
}

Baked solve_dense(const Scene& scene) {
  const Context context(2);
  Baked baked;
  baked.patches = make_patches(scene, {.max_edge = no_max_edge});
  const Tracer tracer(baked.patches, context);
  luxel::solve_dense(baked.patches, tracer, baked.solution, {}, context);
  return baked;
}

Baked solve_sampled(const Scene& scene, const SampledOptions& options, int threads = 2) {
  const Context context(threads);
  Baked baked;
  baked.patches = make_patches(scene, {.max_edge = 0.5f});
  const Tracer tracer(baked.patches, context);
  luxel::solve_sampled(baked.patches, tracer, baked.solution, options, context);
  return baked;
}

// The colour error is only that of 5 nm wide bands in the product of lamp, paint and eye: 0.3 %, and a
// sixteenth of it where they are a quarter as wide.
TEST(Spectral, a_room_of_one_paint_has_the_colour_of_the_integral) {
  const auto truth =
      fine_colour([](double w) { return lamp.at(w, Beyond::zero) / (1.0 - paint.at(w, Beyond::holds)); });
  for (const auto& [step, fraction] : {std::pair(5.0, 3e-3), std::pair(1.25, 4e-4)}) {
    const auto baked = solve_dense(glowing_cube(paint, lamp, step));
    for (std::size_t p = 0; p < baked.patches.size(); ++p) {
      const auto found = colour_of_patch(baked, p);
      for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], truth[i], fraction * truth.r) << "patch " << p;
    }
  }
}

// Two paints that look alike in white light: a grey, and one of the same colour with hills and valleys that
// no eye sees. Each bounce multiplies, and 1 / (1 - rho) is convex: the hilly room is brighter (Jensen). In
// plain colour both would be the same.
TEST(Spectral, paints_that_look_alike_make_rooms_that_do_not) {
  const auto at = wavelengths(4.0);
  const auto bands = make_wavebands(at);
  const BandColours colours(bands);
  const auto white = ColourSpectra(bands).light(Vec3(1.0f));
  // Hills, minus their visible colour.
  std::array<std::vector<double>, 3> seen;
  std::vector<double> hills;
  for (std::size_t b = 0; b < at.size(); ++b) {
    hills.push_back((b / 6) % 2 == 0 ? 0.35 : -0.35);
    for (int i = 0; i < 3; ++i)
      seen[static_cast<std::size_t>(i)].push_back(static_cast<double>(white[b]) * colours.of(b)[i]);
  }
  const auto dot = [](const auto& a, const auto& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
  };
  glm::dmat3 gram;
  Vec3d shown;
  for (int i = 0; i < 3; ++i) {
    shown[i] = dot(hills, seen[static_cast<std::size_t>(i)]);
    for (int j = 0; j < 3; ++j)
      gram[i][j] = dot(seen[static_cast<std::size_t>(i)], seen[static_cast<std::size_t>(j)]);
  }
  const auto part = glm::inverse(gram) * shown;
  std::vector<Spectrum::Sample> hilly, even, light;
  for (std::size_t b = 0; b < at.size(); ++b) {
    for (int i = 0; i < 3; ++i) hills[b] -= part[i] * seen[static_cast<std::size_t>(i)][b];
    hilly.push_back({at[b], 0.5 + hills[b]});
    ASSERT_GT(hilly.back().value, 0.0);
    ASSERT_LT(hilly.back().value, 1.0);
    even.push_back({at[b], 0.5});
    light.push_back({at[b], static_cast<double>(white[b]) / bands[b].width});
  }
  const auto in_even = colour_of_patch(solve_dense(glowing_cube(Spectrum(even), Spectrum(light), 4.0)), 0);
  const auto in_hilly = colour_of_patch(solve_dense(glowing_cube(Spectrum(hilly), Spectrum(light), 4.0)), 0);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(in_even[i], 2.0, 1e-4);
  EXPECT_GT(luminance(Vec3(in_hilly)), 1.1 * 2.0);
}

// The same rays, the same doublings, all bands in proportion.
TEST(Spectral, a_grey_room_has_the_light_of_plain_colour) {
  auto scene = truth::cube_a();
  scene.materials[2].reflectance = Vec3(0.2f);
  const auto plain = solve_sampled(scene, {.error = 0.05, .error_measure = ErrorMeasure::power});
  scene.wavelengths = wavelengths(10.0);
  const auto spectral = solve_sampled(scene, {.error = 0.05, .error_measure = ErrorMeasure::power});
  EXPECT_EQ(plain.solution.provenance.rays, spectral.solution.provenance.rays);
  EXPECT_NEAR(plain.solution.predicted_error / spectral.solution.predicted_error, 1.0, 1e-3);
  for (std::size_t p = 0; p < plain.patches.size(); ++p) {
    const auto a = colour_of_patch(plain, p);
    const auto b = colour_of_patch(spectral, p);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(b[i] / a[i], 1.0, 1e-4) << "patch " << p;
  }
  const auto difference = compare_solutions(plain, spectral);
  EXPECT_LT(difference.relative_rms, 1e-4);
}

TEST(Spectral, pictures_of_a_glowing_room_are_of_its_colour_by_every_road) {
  const auto scene = glowing_cube(paint, lamp, 10.0);
  const auto baked = solve_dense(scene);
  const auto expected = colour_of_patch(baked, 0) / std::numbers::pi;
  const Context context(2);
  const Tracer tracer(baked.patches, context);
  const auto expect_mean = [&](const Image& picture, double fraction) {
    const auto mean = mean_color(picture);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(static_cast<double>(mean[i]), expected[i], fraction * expected.r);
  };
  expect_mean(render(baked.patches, make_smooth_light(baked.patches, baked.solution), tracer, inside,
                     {.width = 24, .height = 18}, context),
              1e-4);
  expect_mean(gather_picture(baked.patches, baked.solution, tracer, inside,
                             {.width = 24, .height = 18, .rays = 64}, context),
              0.01);
  const auto traced =
      trace_picture(baked.patches, tracer, inside, {24, 18}, {.limits = {.samples = 128}}, context);
  expect_mean(traced.radiance, 0.01);
  EXPECT_GT(traced.standard_error.pixels[0].r, 0.0f);
}

TEST(Spectral, every_number_of_threads_gives_the_same_bytes) {
  auto scene = truth::l_room();
  scene.materials[0].reflectance_spectrum = paint;
  scene.wavelengths = wavelengths(12.5);
  const auto one = solve_sampled(scene, {.error = 0.1, .error_measure = ErrorMeasure::power}, 1);
  for (const int threads : {2, 5}) {
    const auto many = solve_sampled(scene, {.error = 0.1, .error_measure = ErrorMeasure::power}, threads);
    EXPECT_EQ(one.solution.irradiance.front, many.solution.irradiance.front);
    EXPECT_EQ(one.solution.standard_error.front, many.solution.standard_error.front);
  }
}

TEST(Spectral, the_file_keeps_the_wavelengths) {
  const auto path = std::filesystem::path(testing::TempDir()) / "luxel_spectral.vtkhdf";
  auto baked = solve_dense(glowing_cube(paint, lamp, 10.0));
  write_solution(path, baked.patches, baked.solution);
  const auto again = read_solution(path);
  EXPECT_EQ(again.patches.wavebands, baked.patches.wavebands);
  EXPECT_EQ(again.patches.bands[3], "430 nm");
  EXPECT_EQ(again.solution.radiosity.front, baked.solution.radiosity.front);
  std::filesystem::remove(path);
  baked.patches.wavebands[2].width = 0.0;
  EXPECT_THROW(write_solution(path, baked.patches, baked.solution), MismatchError);
  baked.patches.wavebands.resize(2);
  EXPECT_THROW(write_solution(path, baked.patches, baked.solution), MismatchError);
  EXPECT_FALSE(baked.patches.has_colours());
}

}  // namespace
}  // namespace luxel
