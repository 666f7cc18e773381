// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/output_estimate.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "luxel/classical/stochastic_jacobi.h"
#include "luxel/core/ending_of.h"
#include "luxel/core/error.h"
#include "luxel/image/image_file.h"
#include "luxel/runs/quantity.h"

namespace luxel {
namespace {

// The solver's first light takes a rough solve like the measured one, and then a longer one.
constexpr double glances_of_first_light = 3.0;
// Times of outputs, in units of the time of the smooth light, which is also linear in the patches. Measured
// on rooms of 50,000 to 120,000 patches.
constexpr double surfaces_per_mesh = 2.0;
constexpr double surfaces_per_solution = 6.0;
constexpr double surfaces_per_page = 8.0;
// Parts of the picture that are drawn: the width and height of the picture are divided by these.
constexpr int small_divisor = 8;
constexpr int large_divisor = 64;
constexpr double margin = 1.1;         // of the estimate
constexpr double rest = 0.05;          // s, to free memory and end
constexpr double part_of_pages = 0.5;  // of the time left: texels are gathered until it is over

class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point begin_ = Clock::now();
};

// The middle of a picture, its width and height divided by `divisor`: its rays are as dense as those of the
// whole picture, which determines their speed.
Camera middle_of(Camera camera, int divisor) {
  const auto half = 0.5f * glm::radians(camera.vertical_fov);
  camera.vertical_fov = 2.0f * glm::degrees(std::atan(std::tan(half) / static_cast<float>(divisor)));
  return camera;
}

// Seconds of the picture: drawn, mapped to the display and encoded. Two parts of it give the cost per picture
// and the cost per pixel.
double picture_seconds(const Baked& baked, const SmoothLight& light, const Tracer& tracer,
                       const Camera& camera, const OutputSettings& settings, const Context& context) {
  const auto& whole = settings.picture.render;
  const auto pixels_of = [](const RenderOptions& o) { return static_cast<double>(o.width) * o.height; };
  const auto measured = [&](int divisor) {
    auto part = whole;
    part.width = std::max(1, whole.width / divisor);
    part.height = std::max(1, whole.height / divisor);
    const Stopwatch watch;
    const auto picture =
        render_picture(baked.patches, light, tracer, middle_of(camera, divisor), part, context);
    [[maybe_unused]] const auto bytes =
        png_of(tone_map(picture.radiance, settings.look.tone, picture.edges, picture.sky));
    return std::pair(pixels_of(part), watch.seconds());
  };
  const auto [few, first] = measured(large_divisor);
  const auto [more, second] = measured(small_divisor);
  const auto per_pixel = more > few ? std::max(0.0, second - first) / (more - few) : 0.0;
  return first + per_pixel * pixels_of(whole);
}

}  // namespace

OutputEstimate estimate_outputs(const Baked& baked, const Tracer& tracer, const OutputSettings& settings,
                                const Workplace& place) {
  OutputEstimate estimate;
  Baked glanced{baked.patches, {}};
  const Stopwatch watch;
  try {
    solve_stochastic_jacobi(glanced.patches, tracer, glanced.solution, glance(baked.patches), place.context);
  } catch (const InputError&) {
    return estimate;  // no light: the solver reports it
  }
  estimate.first_light = glances_of_first_light * watch.seconds();

  const auto& outputs = settings.run.outputs;
  const Stopwatch of_surface;
  const auto light =
      make_smooth_light(glanced.patches, glanced.solution, settings.look.smooth, place.context);
  const auto surface = of_surface.seconds();
  double seconds = surface;
  for (const auto& output : outputs) {
    if (is_solution(output))
      seconds += surfaces_per_solution * surface;
    else if (!is_picture(output))
      seconds += (is_page(output) ? surfaces_per_page : surfaces_per_mesh) * surface;
  }
  if (!std::all_of(outputs.begin(), outputs.end(), [](const auto& o) { return is_solution(o); }))
    estimate.camera = place.record.stage("camera", [&](auto&) {
      return camera_of(settings.picture, settings.look, baked, tracer, place.context);
    });
  if (std::any_of(outputs.begin(), outputs.end(), is_picture))
    seconds += picture_seconds(glanced, light, tracer, *estimate.camera, settings, place.context);
  estimate.outputs = margin * seconds + rest;
  place.console.detail("estimate",
                       fmt::format("{} until the first light, {} for the outputs",
                                   taken_time(estimate.first_light), taken_time(estimate.outputs)));
  const auto* mesh = settings.mesh.settings;
  if (mesh && mesh->on_pages() && place.budget)
    estimate.outputs = std::max(estimate.outputs, part_of_pages * place.budget->left());
  return estimate;
}

}  // namespace luxel
