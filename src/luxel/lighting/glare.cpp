// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/glare.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/address.h"
#include "luxel/core/error.h"
#include "luxel/core/sobol.h"
#include "luxel/core/spherical_triangle.h"
#include "luxel/core/warp.h"
#include "luxel/lighting/position_index.h"
#include "luxel/photometry/opening.h"
#include "luxel/render/doubled_samples.h"
#include "luxel/render/surface_point.h"
#include "luxel/trace/point_sight.h"

namespace luxel {
namespace {

constexpr double exact_pi = std::numbers::pi;
constexpr std::uint32_t min_rays = 1024;        // as of probes
constexpr double flattest = 0.0871557427;       // cosine of 85 degrees
constexpr double max_solid_angle = 0.1;         // sr, of a source of UGR (CIE 147)
constexpr double normal_quantile = 1.96;        // of a 95 % interval
constexpr std::size_t observers_per_call = 16;  // between polls of the monitor

// At very flat angles, intensity over area is no good estimate of the luminance of a flat opening.
bool is_too_flat(const LuminousOpening& opening, const Vec3d& direction) {
  switch (opening.shape) {
    case OpeningShape::rectangle:
    case OpeningShape::ellipse:
      return projected_area(opening, direction) < flattest * projected_area(opening, {0.0, 0.0, 1.0});
    case OpeningShape::vertical_disk: {
      const Vec3d face(opening.size.y, opening.size.x, 0.0);  // at right angles to the disk
      return projected_area(opening, direction) < flattest * projected_area(opening, face);
    }
    default:
      return false;
  }
}

}  // namespace

// An observer, and the axes of what it sees.
struct GlareMeter::View {
  LampRayOrigin origin;
  Vec3d eye, forward, aside, above;
  std::uint64_t key = 0;

  std::optional<double> index_of(const Vec3d& position) const {
    const auto way = position - eye;
    return position_index(glm::dot(way, forward), glm::dot(way, aside), glm::dot(way, above));
  }
};

GlareMeter::GlareMeter(const SolutionProbe& probe, const Vec3d& up)
    : probe_(probe), up_(up), surfaces_(find_lamp_surfaces(probe.patches())) {
  const auto& lights = probe.patches().point_lights;
  for (std::uint32_t i = 0; i < lights.size(); ++i)
    if (has_opening(lights[i].light)) luminaires_.push_back(i);
}

ObservedGlare GlareMeter::at(const GlareObserver& observer, const GlareOptions& options,
                             std::uint64_t key) const {
  View view;
  view.origin = probe_.place({observer.eye, observer.view}).rays;
  view.eye = Vec3d(view.origin.position);
  view.forward = glm::normalize(Vec3d(observer.view));
  view.key = key;
  // Up in the view; looking straight up or down, any direction.
  const auto level = glm::cross(view.forward, up_);
  const Frame frame(observer.view);
  view.aside = glm::length(level) > 1e-6 ? glm::normalize(level) : Vec3d(frame.s);
  view.above = glm::cross(view.aside, view.forward);

  ObservedGlare observed;
  for (const auto light : luminaires_) add_luminaire(view, light, options, observed);
  for (const auto& lamp : surfaces_) add_surface(view, lamp, options, observed);
  std::stable_sort(observed.sources.begin(), observed.sources.end(),
                   [](const GlareSource& a, const GlareSource& b) { return a.glare() > b.glare(); });
  const auto background_sampling = find_background(view, options, observed);
  double sum = 0.0, squared_error = 0.0;
  for (const auto& source : observed.sources) {
    sum += source.glare();
    squared_error += source.squared_error;
    if (source.solid_angle > max_solid_angle) ++observed.large;
  }
  if (!(sum > 0.0)) return observed;
  if (!(observed.background > 0.0)) {
    observed.ugr = observed.low = observed.high = -ObservedGlare::nothing;
    return observed;
  }
  observed.ugr = 8.0 * std::log10(0.25 * sum / observed.background);
  const auto of_sources = std::sqrt(squared_error) / sum;
  const auto relative = std::hypot(of_sources, observed.background_error / observed.background);
  const auto by_rays = std::hypot(of_sources, background_sampling / observed.background);
  if (relative > 0.0) observed.sampling = by_rays * by_rays / (relative * relative);
  const auto reach = 8.0 * std::log10(1.0 + normal_quantile * relative);
  observed.low = observed.ugr - reach;
  observed.high = observed.ugr + reach;
  return observed;
}

// source: solid angle of all of it, and what fraction is visible.
void GlareMeter::add_source(const View& view, GlareSource source, std::uint32_t rays,
                            ObservedGlare& observed) const {
  const auto index = view.index_of(source.position);
  if (!index) {
    ++observed.ignored;
    return;
  }
  source.position_index = *index;
  const auto whole = source.glare();
  // Independent rays would have this variance; those of a Sobol sequence have less.
  source.squared_error = whole * whole * source.visible * (1.0 - source.visible) / static_cast<double>(rays);
  source.solid_angle *= source.visible;
  observed.sources.push_back(std::move(source));
}

void GlareMeter::add_luminaire(const View& view, std::uint32_t light_index, const GlareOptions& options,
                               ObservedGlare& observed) const {
  const auto& lamp = probe_.patches().point_lights[light_index];
  const auto& light = lamp.light;
  const Vec3d centre(light.position);
  const auto way = centre - view.eye;
  if (!(glm::dot(way, view.forward) > 0.0)) return;
  const auto direction = in_local_axes(light, -way);
  double candela = 0.0;
  for (std::size_t b = 0; b < lamp.intensity.size(); ++b)
    candela += probe_.solved().lux(b) * static_cast<double>(lamp.intensity[b]);
  candela *= relative_intensity(light, view.eye);
  if (!(candela > 0.0)) return;
  const OwenSobol numbers(nth_key(view.key, std::uint64_t{light_index} + gather_replicates));
  const auto& panes = probe_.lamp_rays().panes();
  std::uint32_t seen = 0;
  double through = 0.0;  // sum of luminous transmittances
  for (std::uint32_t i = 0; i < options.lamp_rays; ++i) {
    const auto sight =
        sight_of(light, view.eye, view.forward,
                 {static_cast<double>(numbers.at(i, 0)), static_cast<double>(numbers.at(i, 1))});
    ++observed.rays;
    const Ray ray{view.origin.position, Vec3(sight.direction)};
    if (probe_.tracer().occluded(ray, sight.distance)) continue;
    ++seen;
    through += panes.luminous(panes.along(ray, sight.distance));
  }
  if (seen == 0) return;
  if (is_too_flat(light.photometry->opening, direction)) {
    ++observed.ignored;
    return;
  }
  const auto area = projected_area(light.photometry->opening, direction);
  GlareSource source;
  source.name = light.name;
  source.position = centre;
  source.luminance = candela / area * through / seen;
  source.solid_angle = area / glm::dot(way, way);
  source.visible = static_cast<double>(seen) / static_cast<double>(options.lamp_rays);
  add_source(view, std::move(source), options.lamp_rays, observed);
}

void GlareMeter::add_surface(const View& view, const LampSurface& lamp, const GlareOptions& options,
                             ObservedGlare& observed) const {
  const auto& patches = probe_.patches();
  const auto per_patch = std::max(1u, options.lamp_rays / static_cast<std::uint32_t>(lamp.patches.size()));
  const auto& panes = probe_.lamp_rays().panes();
  double solid_angle = 0.0, seen_angle = 0.0, light = 0.0;  // light: sum of luminance and solid angle
  std::uint32_t rays = 0;
  Vec3d middle(0.0);
  for (const auto p : lamp.patches) {
    const auto points = patches.points(p);
    if (!(glm::dot(Vec3d(patches.normal[p]), view.eye - Vec3d(points[0])) > 0.0)) continue;
    const SphericalTriangle triangle(
        {Vec3d(points[0]) - view.eye, Vec3d(points[1]) - view.eye, Vec3d(points[2]) - view.eye});
    const OwenSobol numbers(nth_key(view.key, (std::uint64_t{1} << 32) + p));
    std::uint32_t seen = 0;
    double through = 0.0;  // sum of luminous transmittances
    for (std::uint32_t i = 0; i < per_patch; ++i) {
      const auto at = surface_point(patches, p, false, uniform_triangle(numbers.at(i, 0), numbers.at(i, 1)));
      const auto way = Vec3d(at.position) - view.eye;
      const auto distance = glm::length(way);
      if (!(glm::dot(way, view.forward) > 0.0)) continue;
      ++rays;
      ++observed.rays;
      const Ray ray{view.origin.position, Vec3(way / distance)};
      const auto before = static_cast<float>(distance * (1.0 - 1e-5));
      if (probe_.tracer().occluded(ray, before)) continue;
      ++seen;
      through += panes.luminous(panes.along(ray, before));
    }
    double luminance = 0.0;
    for (std::size_t b = 0; b < patches.band_count(); ++b)
      luminance += probe_.solved().lux(b) * static_cast<double>(patches.emittance(p, b)) / exact_pi;
    const auto visible = triangle.solid_angle() * seen / per_patch;
    solid_angle += triangle.solid_angle();
    seen_angle += visible;
    light += luminance * triangle.solid_angle() * through / per_patch;
    middle += visible * Vec3d(patches.centroid(p));
  }
  if (!(seen_angle > 0.0)) return;
  GlareSource source;
  source.name = lamp.name;
  source.position = middle / seen_angle;
  source.luminance = light / seen_angle;
  source.solid_angle = solid_angle;
  source.visible = std::min(1.0, seen_angle / solid_angle);
  add_source(view, std::move(source), rays, observed);
}

double GlareMeter::find_background(const View& view, const GlareOptions& options,
                                   ObservedGlare& observed) const {
  const auto& solved = probe_.solved();
  const auto& patches = probe_.patches();
  std::vector<OwenSobol> numbers;
  for (std::uint64_t r = 0; r < gather_replicates; ++r) numbers.emplace_back(nth_key(view.key, r));
  const Frame frame(view.origin.normal);
  std::array<double, gather_replicates> sums{};  // lx
  std::vector<double> errors(solved.error_sums(), 0.0);
  std::uint64_t rays = 0;
  const auto sample = [&](std::uint32_t r, std::uint32_t i) {
    const Ray ray{view.origin.position,
                  frame.to_world(cosine_hemisphere(numbers[r].at(i, 0), numbers[r].at(i, 1)))};
    const auto hit = probe_.tracer().nearest(ray);
    ++rays;
    const auto& panes = probe_.lamp_rays().panes();
    const auto through = panes.along(ray, hit.distance);
    const auto sky_patch = patches.sky_patches.patch_of(Vec3d(ray.direction));
    for (std::size_t b = 0; b < solved.bands(); ++b)
      sums[r] += solved.lux(b) * in_band(through, b) *
                 (hit ? solved.reflected(hit, b) : patches.sky_radiosity(sky_patch, b));
    solved.add_error(hit, panes.luminous(through), errors);
  };
  DoubledVariance<double> doubled;
  double mean = 0.0, sampling_error = 0.0;
  const auto is_enough = [&](std::uint32_t samples) {
    auto lux = sums;
    mean = 0.0;
    for (auto& l : lux) {
      l /= static_cast<double>(samples);
      mean += l / static_cast<double>(gather_replicates);
    }
    const auto spread = error_of_replicates(lux);
    sampling_error = std::sqrt(doubled.of(spread * spread));
    observed.reached = samples * gather_replicates >= min_rays && sampling_error <= options.error * mean;
    return observed.reached;
  };
  double_samples(options.max_rays, sample, is_enough);
  observed.rays += rays;
  observed.background = mean / exact_pi;
  observed.background_error =
      std::hypot(sampling_error, solved.error(errors, static_cast<double>(rays))) / exact_pi;
  return sampling_error / exact_pi;
}

namespace {

void check(std::span<const GlareObserver> observers, const GlareOptions& options) {
  if (!(options.error > 0.0 && options.error < 1.0))
    throw InputError(
        fmt::format("the error of a background must be above 0 and below 1, not {}", options.error));
  if (options.max_rays < min_rays)
    throw InputError(fmt::format("an observer takes at least {} rays, not {}", min_rays, options.max_rays));
  if (options.lamp_rays < 1) throw InputError("an observer takes at least one ray per lamp, not 0");
  for (std::size_t i = 0; i < observers.size(); ++i)
    if (!std::isfinite(glm::length(observers[i].eye)) ||
        !(std::abs(glm::length(observers[i].view) - 1.0f) < 1e-3f))
      throw InputError(fmt::format("observer {} needs a finite position and a unit view direction", i));
}

}  // namespace

std::vector<ObservedGlare> observe_glare(const GlareMeter& meter, std::span<const GlareObserver> observers,
                                         const GlareOptions& options, const Context& context) {
  check(observers, options);
  std::vector<ObservedGlare> glare(observers.size());
  std::uint64_t rays = 0;
  for (std::size_t first = 0; first < observers.size(); first += observers_per_call) {
    const auto done = static_cast<double>(first) / static_cast<double>(observers.size());
    if (context.report({"observers", done, rays}) == Next::stop) return {};
    const auto count = std::min(observers_per_call, observers.size() - first);
    context.for_chunks(count, 1, [&](std::size_t begin, std::size_t end, int) {
      for (auto i = first + begin; i < first + end; ++i)
        glare[i] = meter.at(observers[i], options,
                            stream_key(options.seed, RandomPurpose::probes, static_cast<std::uint32_t>(i)));
    });
    for (std::size_t i = first; i < first + count; ++i) rays += glare[i].rays;
  }
  context.report({"observers", 1.0, rays});
  return glare;
}

}  // namespace luxel
