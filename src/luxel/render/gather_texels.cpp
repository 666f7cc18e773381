// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/gather_texels.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <compare>
#include <limits>

#include <fmt/format.h>

#include "luxel/core/address.h"
#include "luxel/core/cross.h"
#include "luxel/core/error.h"
#include "luxel/patch/side.h"
#include "luxel/render/point_gather.h"
#include "luxel/render/texel_places.h"
#include "luxel/scene/band_colours.h"
#include "luxel/surface/smooth_irradiance.h"

namespace luxel {
namespace {

constexpr std::uint32_t min_rays = 64;
constexpr std::size_t texels_per_chunk = 64;
constexpr std::size_t max_between_calls = 1 << 14;  // texels between polls of the monitor

void check(const PatchSet& patches, const Solution& solution, const SmoothLight& light,
           const TexelOptions& options, const Lightmap& lightmap) {
  const auto values = patches.size() * patches.band_count();
  if (solution.bands != patches.bands || solution.irradiance.front.size() != values ||
      solution.irradiance.back.size() != values || light.corners.size() != patches.size())
    throw MismatchError(
        fmt::format("the solution's light is not of these {} patches: solve this scene", patches.size()));
  if (lightmap.atlas.chart_of.size() != side_count(patches.size()))
    throw MismatchError(fmt::format("the atlas has {} sides but the patches have {}: lay out this scene",
                                    lightmap.atlas.chart_of.size(), side_count(patches.size())));
  if (!(options.error >= 0.0 && options.error <= 1.0))
    throw InputError(
        fmt::format("the error asked of a texel must be from 0 to 1, but it is {}", options.error));
  if (options.max_rays < min_rays)
    throw InputError(
        fmt::format("a final gather takes at least {} rays a texel, not {}", min_rays, options.max_rays));
}

// Values of the solution at single sides and points.
class SolvedLight {
 public:
  SolvedLight(const PatchSet& patches, const Solution& solution, const SmoothLight& light)
      : patches_(patches), solution_(solution), light_(light), colours_(patches.colours()) {}

  const PatchSet& patches() const { return patches_; }
  bool is_diffuser(SideId side) const { return patches_.material_of(side.patch()).is_diffuser(); }

  Vec3d at(const TexelPlace& place) const {
    const auto bands = colours_.bands();
    return colour_of(place.side, [&](SideId side, std::size_t b) {
      return smooth_irradiance(light_, side, place.weights, b, bands);
    });
  }

  Vec3d mean(SideId side) const {
    return colour_of(side, [&](SideId from, std::size_t b) {
      return static_cast<double>(row(solution_.irradiance.of(from), from)[b]);
    });
  }

  Vec3d standard_error(SideId side) const {
    if (solution_.standard_error.of(side).empty()) return Vec3d(0.0);
    Vec3d variance(0.0);
    for (std::size_t b = 0; b < colours_.bands(); ++b) {
      const auto far = far_fraction(side, b);
      for (const auto from : {side, side.opposite()}) {
        const auto fraction = from == side ? 1.0 - far : far;
        const auto part =
            fraction * static_cast<double>(row(solution_.standard_error.of(from), from)[b]) * colours_.of(b);
        variance += part * part;
      }
    }
    return glm::sqrt(variance);
  }

  // Error estimate of the smooth light on this side, W/m².
  double uncertainty(SideId side) const {
    std::array<Vec3d, 3> corner;
    for (std::size_t k = 0; k < 3; ++k)
      corner[k] = at({side, {k == 1 ? 1.0f : 0.0f, k == 2 ? 1.0f : 0.0f}, Texel::inside});
    const auto misfit = (corner[0] + corner[1] + corner[2]) / 3.0 - mean(side);
    double rise = 0.0;
    for (std::size_t k = 0; k < 3; ++k) rise = std::max(rise, glm::length(corner[(k + 1) % 3] - corner[k]));
    constexpr double fraction_of_rise = 0.25;
    return std::max({glm::length(standard_error(side)), glm::length(misfit), fraction_of_rise * rise});
  }

 private:
  const float* row(const std::vector<float>& values, SideId side) const {
    return values.data() + side.patch() * colours_.bands();
  }

  // Fraction of the effective irradiance that is of the other side, see effective_irradiance().
  double far_fraction(SideId side, std::size_t band) const {
    const auto albedo = patches_.albedo(side.patch(), band);
    return is_diffuser(side) && albedo > 0.0f
               ? static_cast<double>(patches_.diffuse_transmittance(side.patch(), band) / albedo)
               : 0.0;
  }

  // irradiance(side, band).
  template <typename Irradiance>
  Vec3d colour_of(SideId side, const Irradiance& irradiance) const {
    Vec3d sum(0.0);
    for (std::size_t b = 0; b < colours_.bands(); ++b) {
      auto light = irradiance(side, b);
      if (const auto far = far_fraction(side, b); far > 0.0)
        light = (1.0 - far) * light + far * irradiance(side.opposite(), b);
      sum += light * colours_.of(b);
    }
    return sum;
  }

  const PatchSet& patches_;
  const Solution& solution_;
  const SmoothLight& light_;
  BandColours colours_;
};

// The length of the mean irradiance vector of all sides on the pages, W/m².
double mean_light(const PatchSet& patches, const SolvedLight& light, const Atlas& atlas) {
  Vec3d sum(0.0);
  double area = 0.0;
  for (std::size_t i = 0; i < atlas.chart_of.size(); ++i) {
    const auto side = SideId::at(i);
    if (!atlas.has(side)) continue;
    sum += static_cast<double>(patches.area[side.patch()]) * light.mean(side);
    area += static_cast<double>(patches.area[side.patch()]);
  }
  return area > 0.0 ? glm::length(sum) / area : 0.0;
}

// The origin of a texel's rays: moved slightly into the patch, so that walls along its border are beside the
// point and not above it.
SurfacePoint point_of(const PatchSet& patches, const Atlas& atlas, const TexelPlace& place) {
  constexpr float max_drawn_in = 0.25f;  // fraction of the distance to the centroid
  constexpr float from_border = 0.02f;   // texels
  const auto& t = atlas.corners[place.side.index()];
  const auto b = t[1] - t[0], c = t[2] - t[0];
  const auto longest = std::max({glm::length(b), glm::length(c), glm::length(c - b)});
  const auto third_height = std::abs(cross(b, c)) / (3.0f * longest);
  const auto drawn_in =
      third_height > 0.0f ? std::min(max_drawn_in, from_border / third_height) : max_drawn_in;
  return surface_point(patches, place.side.patch(), place.side.is_back(),
                       place.weights + drawn_in * (Vec2(1.0f / 3.0f) - place.weights));
}

struct Wanting {
  std::uint32_t page, texel;
  auto operator<=>(const Wanting&) const = default;
};

// Errors by which a texel differs from what is known otherwise, for more rays.
constexpr double errors_off = 3.0;

// Fills all texels with the smooth light; returns those for which it is not accurate enough. No pages if the
// monitor stopped the work.
std::vector<Wanting> interpolate(const std::vector<std::vector<TexelPlace>>& places, const SolvedLight& light,
                                 const PointGather::Limits& limits, Lightmap& lightmap, TexelReport& report,
                                 const Context& context) {
  const bool all = limits.with_light_vector;
  std::vector<Wanting> wanting;
  const auto& atlas = lightmap.atlas;
  std::vector<std::int8_t> is_wanting(atlas.chart_of.size(), -1);  // [side]; -1: not yet determined
  const auto wants = [&](SideId side) {
    if (is_wanting[side.index()] < 0)
      is_wanting[side.index()] =
          light.uncertainty(side) > limits.error * std::max(glm::length(light.mean(side)), limits.least) ? 1
                                                                                                         : 0;
    return is_wanting[side.index()] > 0;
  };
  for (std::uint32_t p = 0; p < places.size(); ++p) {
    const auto done = static_cast<double>(p) / static_cast<double>(places.size());
    if (context.report({"smooth light", done}) == Next::stop) {
      lightmap.pages.clear();
      return {};
    }
    auto& page = lightmap.pages.emplace_back();
    page.irradiance = page.standard_error = Image(atlas.page_size, atlas.page_size);
    page.texels.assign(places[p].size(), Texel::empty);
    if (all) page.light_vector.assign(3, Image(atlas.page_size, atlas.page_size));
    for (std::uint32_t i = 0; i < places[p].size(); ++i) {
      const auto& place = places[p][i];
      page.texels[i] = place.kind;
      if (place.kind == Texel::empty) continue;
      ++report.texels;
      page.irradiance.pixels[i] = in_gamut(light.at(place));
      page.standard_error.pixels[i] = Vec3(light.standard_error(place.side));
      if (light.is_diffuser(place.side)) continue;
      if (all || (limits.error > 0.0 && wants(place.side))) wanting.push_back({p, i});
    }
  }
  return wanting;
}

// Adds to `found`, each once, the texels that differ from all of their neighbours by more than their errors:
// a few rays may all miss a small bright surface, and then agree with each other.
std::vector<Wanting> standing_out(const Lightmap& lightmap, const std::vector<Wanting>& gathered,
                                  std::vector<Wanting> found) {
  for (const auto& [p, texel] : gathered) {
    const auto& page = lightmap.pages[p];
    const auto width = page.irradiance.width, height = page.irradiance.height;
    const auto x = static_cast<int>(texel) % width, y = static_cast<int>(texel) / width;
    const auto own = luminance(page.irradiance.pixels[texel]);
    float low = std::numeric_limits<float>::infinity(), high = 0.0f;
    for (auto j = std::max(0, y - 1); j <= std::min(height - 1, y + 1); ++j)
      for (auto i = std::max(0, x - 1); i <= std::min(width - 1, x + 1); ++i) {
        const auto at = static_cast<std::size_t>(j) * static_cast<std::size_t>(width) + i;
        if (at == texel || page.texels[at] == Texel::empty) continue;
        low = std::min(low, luminance(page.irradiance.pixels[at]));
        high = std::max(high, luminance(page.irradiance.pixels[at]));
      }
    const auto off = high > 0.0f ? std::max(low - own, own - high) : 0.0f;
    if (off > static_cast<float>(errors_off) * luminance(page.standard_error.pixels[texel]))
      found.push_back({p, texel});
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

// What the patches know of a texel.
struct SmoothTexel {
  Vec3d irradiance, standard_error;
  double uncertainty = 0.0;  // see SolvedLight
};

// The mean of both, weighted by the inverse of their squared errors: where rays know little more than the
// patches do, texels of rays alone would be specks in a smooth wall. The gathered error counts double, since
// rays that all miss a small bright surface agree with each other.
PointGather::Result weighted_mean(PointGather::Result gathered, const SmoothTexel& smooth) {
  constexpr double doubt = 2.0;
  const auto squared = [](double x) { return x * x; };
  const auto of_smooth = squared(smooth.uncertainty);
  const auto of_gathered = squared(doubt * glm::length(gathered.standard_error));
  if (!(of_gathered > 0.0)) return gathered;
  const auto weight = of_smooth / (of_smooth + of_gathered);
  gathered.irradiance = weight * gathered.irradiance + (1.0 - weight) * smooth.irradiance;
  gathered.standard_error = glm::sqrt(weight * weight * gathered.standard_error * gathered.standard_error +
                                      squared(1.0 - weight) * smooth.standard_error * smooth.standard_error);
  return gathered;
}

// Gathers light at texels, and writes it to pages that hold interpolated light so far.
class TexelGather {
 public:
  // Stores references.
  TexelGather(const Lightmap& lightmap, const std::vector<std::vector<TexelPlace>>& places,
              const SolvedLight& light, const PointGather& gather, std::uint64_t seed, const Context& context)
      : atlas_(lightmap.atlas),
        places_(places),
        light_(light),
        gather_(gather),
        seed_(seed),
        context_(context) {}

  // begin, end: the fraction of the whole work, for progress. Returns false where the monitor stops the work.
  bool run(const std::vector<Wanting>& wanting, const PointGather::Limits& limits, double begin, double end,
           Lightmap& lightmap, TexelReport& report);

  // The texels gathered so far that differ from the smooth light by more than the errors of both.
  const std::vector<Wanting>& doubtful() const { return doubtful_; }

 private:
  const Atlas& atlas_;
  const std::vector<std::vector<TexelPlace>>& places_;
  const SolvedLight& light_;
  const PointGather& gather_;
  std::uint64_t seed_;
  const Context& context_;
  std::vector<Wanting> doubtful_;
};

bool TexelGather::run(const std::vector<Wanting>& wanting, const PointGather::Limits& limits, double begin,
                      double end, Lightmap& lightmap, TexelReport& report) {
  // Groups of texels of about a tenth of a second: the number of rays per texel varies widely.
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds between_calls(100);
  constexpr std::uint32_t rays_at_first = 1 << 17;
  std::size_t at_a_time = std::max(1u, rays_at_first / limits.max_rays);
  std::vector<PointGather::Result> results;
  for (std::size_t first = 0, count = 0; first < wanting.size(); first += count) {
    const auto fraction = static_cast<double>(first) / static_cast<double>(wanting.size());
    if (context_.report({"texels", begin + fraction * (end - begin), report.rays}) == Next::stop)
      return false;
    const auto begun = Clock::now();
    count = std::min(wanting.size() - first, at_a_time);
    results.resize(count);
    const auto chunk = std::clamp<std::size_t>(count / texels_per_chunk, 1, texels_per_chunk);
    context_.for_chunks(count, chunk, [&](std::size_t from, std::size_t to, int) {
      for (auto i = from; i < to; ++i) {
        const auto [page, texel] = wanting[first + i];
        results[i] = gather_.at(point_of(light_.patches(), atlas_, places_[page][texel]), limits,
                                mix64(stream_key(seed_, RandomPurpose::lightmap_texels, texel) + page));
      }
    });
    for (std::size_t i = 0; i < count; ++i) {
      auto& page = lightmap.pages[wanting[first + i].page];
      const auto texel = wanting[first + i].texel;
      const auto& place = places_[wanting[first + i].page][texel];
      const SmoothTexel smooth{light_.at(place), light_.standard_error(place.side),
                               light_.uncertainty(place.side)};
      if (glm::length(results[i].irradiance - smooth.irradiance) >
          errors_off * std::hypot(glm::length(results[i].standard_error), smooth.uncertainty))
        doubtful_.push_back(wanting[first + i]);
      const auto mixed = page.light_vector.empty() ? weighted_mean(results[i], smooth) : results[i];
      page.irradiance.pixels[texel] = in_gamut(mixed.irradiance);
      page.standard_error.pixels[texel] = Vec3(mixed.standard_error);
      for (std::size_t axis = 0; axis < page.light_vector.size(); ++axis)
        page.light_vector[axis].pixels[texel] = Vec3(results[i].light_vector[axis]);
      report.rays += results[i].rays;
      ++report.gathered;
      report.short_of_it += results[i].reached ? 0 : 1;
    }
    const auto took = Clock::now() - begun;
    if (took > between_calls) at_a_time = std::max<std::size_t>(1, at_a_time / 2);
    if (took < between_calls / 2) at_a_time = std::min(max_between_calls, 2 * at_a_time);
  }
  return true;
}

}  // namespace

TexelReport gather_texels(const LightmapInput& input, const SmoothLight& light, const TexelOptions& options,
                          Lightmap& lightmap, const Context& context) {
  const auto& patches = input.patches;
  const auto* tracer = input.tracer;
  check(patches, input.solution, light, options, lightmap);
  if (options.directional && !(tracer && options.error > 0.0))
    throw InputError("the directions of light come from a final gather: ask for one");
  const auto& atlas = lightmap.atlas;
  const SolvedLight solved(patches, input.solution, light);
  std::vector<bool> is_dark(atlas.chart_of.size());
  for (std::size_t i = 0; i < is_dark.size(); ++i)
    is_dark[i] = !(glm::length(solved.mean(SideId::at(i))) > 0.0);
  const auto places = find_texel_places(atlas, is_dark, context);
  const auto least = options.dark * mean_light(patches, solved, atlas);
  TexelReport report;
  lightmap.pages.clear();
  PointGather::Limits limits{tracer ? options.error : 0.0, least, options.max_rays, options.directional};
  const auto wanting = interpolate(places, solved, limits, lightmap, report, context);
  if (wanting.empty()) return report;

  const PointGather gather(patches, light, *tracer);
  TexelGather texels(lightmap, places, solved, gather, options.seed, context);
  constexpr double first_part = 0.98;
  report.stopped = !texels.run(wanting, limits, 0.0, first_part, lightmap, report);
  if (report.stopped) return report;
  limits.min_rays = std::min(options.max_rays, 16 * limits.min_rays);
  TexelReport again{.rays = report.rays};
  report.stopped = !texels.run(standing_out(lightmap, wanting, texels.doubtful()), limits, first_part, 1.0,
                               lightmap, again);
  report.rays = again.rays;
  if (!report.stopped) context.report({"texels", 1.0, report.rays});
  return report;
}

}  // namespace luxel
