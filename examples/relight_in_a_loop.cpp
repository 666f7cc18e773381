// SPDX-License-Identifier: Apache-2.0
// Solves a scene once and dims its lamps many times, without tracing another ray: each step costs
// milliseconds. Prints the mean irradiance of all surfaces for each setting of the dimmer; light is linear,
// so the figures are, too.
//
//     relight_in_a_loop scenes/cornell-box.obj
#include <cstdio>
#include <memory>

#include <luxel/luxel.h>
#include <luxel/patch/light_groups.h>

// Area-weighted mean over the fronts of all patches, W/m², in the mean over bands.
static double mean_irradiance(const luxel::PatchSet& patches, const luxel::Solution& light) {
  const auto bands = patches.band_count();
  double sum = 0.0, area = 0.0;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    for (std::size_t b = 0; b < bands; ++b)
      sum += static_cast<double>(patches.area[p] * light.irradiance.front[p * bands + b]);
    area += static_cast<double>(patches.area[p]) * static_cast<double>(bands);
  }
  return sum / area;
}

int main(int count, char** arguments) try {
  if (count != 2) throw luxel::InputError("relight_in_a_loop: expected one scene, OBJ or glTF");
  const luxel::Context context;  // threads for everything below
  const auto scene = luxel::load_scene(arguments[1]);
  auto patches = luxel::make_patches(scene, {.target_count = 2000}, context);
  luxel::set_light_groups(scene, {}, patches);  // a group for each lamp material; rules would join some
  const luxel::Tracer tracer(patches, context);

  // The last answer's samples are what relighting works on.
  std::shared_ptr<const luxel::SampleState> samples;
  luxel::Solution light;
  const luxel::SampledOptions options = {.error = 0.03};
  luxel::solve_sampled(patches, tracer, light, options, {.keep = [&](auto s) { samples = s; }}, context);
  std::printf("dimmer 1.00: %.6f W/m2, solved\n", mean_irradiance(patches, light));

  luxel::Relighter relighter(patches, tracer, samples, options, context);
  for (int step = 4; step >= 0; --step) {
    const auto dimmer = 0.25f * static_cast<float>(step);
    // One weight per light group and band; here all of them alike.
    relighter.set_lamps(std::vector<float>(patches.group_count() * patches.band_count(), dimmer));
    const auto dimmed = relighter.light();
    std::printf("dimmer %.2f: %.6f W/m2\n", static_cast<double>(dimmer), mean_irradiance(patches, dimmed));
  }
} catch (const luxel::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
