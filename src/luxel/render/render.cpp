// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/render.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "luxel/core/address.h"
#include "luxel/core/error.h"
#include "luxel/patch/colour_patches.h"
#include "luxel/render/pane_colours.h"
#include "luxel/render/pinhole.h"
#include "luxel/render/sky_look.h"
#include "luxel/render/visible_luminaires.h"
#include "luxel/scene/band_colours.h"
#include "luxel/solution/solution_file.h"
#include "luxel/surface/smooth_irradiance.h"

namespace luxel {
namespace {

constexpr int max_samples_per_side = 64;
// Between two polls of the monitor: about a tenth of a second on two cores.
constexpr std::size_t rays_between_calls = 1u << 18;
constexpr std::size_t pixels_per_chunk = 64;

// Pixels with edges get samples in twice as many rows and columns, up to this many: nine samples show a crack
// between two boards as dots.
constexpr int fine_rows = 8;
// Estimated fraction of the rendering time spent before those pixels get their additional samples.
constexpr double coarse_part = 0.75;

// Parts of a pixel on an edge: one per sample up to here, 768 bytes per pixel.
constexpr std::size_t max_parts = 64;
// Ratio of brightest to darkest part of a pixel on an edge. Below it, the curve of the mean and the mean of
// the curves differ by 8 of 255 codes at most.
constexpr float edge_contrast = 2.0f;

void check(const PatchSet& patches, const SmoothLight& light, const RenderOptions& options) {
  if (light.corners.size() != patches.size())
    throw MismatchError(
        fmt::format("the smooth light is of {} patches but the scene has {}: make it from "
                    "this scene's solution",
                    light.corners.size(), patches.size()));
  if (options.samples_per_side < 1 || options.samples_per_side > max_samples_per_side)
    throw InputError(fmt::format("samples_per_side must be from 1 to {}, but it is {}", max_samples_per_side,
                                 options.samples_per_side));
}

// Constant data of a picture.
struct Shot {
  const PatchSet& patches;
  const SmoothLight& light;
  const Tracer& tracer;
  const Pinhole& pinhole;
  const RenderOptions& options;
  const BandColours& colours;
  const FineColours& fine;
  const VisibleLuminaires& luminaires;
  const DisplayedSky& sky;
  const PaneColours& panes;
};

// light: scratch, [band] of the side that is seen, [band] of the other one.
Vec3d radiance_at(const Shot& shot, const Ray& ray, const Hit& hit, std::vector<float>& light) {
  if (!hit) return shot.sky.colours().at(Vec3d(ray.direction));
  const auto bands = light.size() / 2;
  const auto add = [&](SideId side, float* to) {
    for (std::size_t band = 0; band < bands; ++band)
      to[band] = smooth_irradiance<float>(shot.light, side, {hit.u, hit.v}, band, bands);
  };
  const auto& material = shot.patches.material_of(hit.patch);
  add(hit.side(), light.data());
  if (material.is_diffuser()) add(hit.side().opposite(), light.data() + bands);
  const auto fraction = texture_ratio_at(shot.patches, shot.fine, hit.patch, hit.u, hit.v);
  return radiance_of(material, hit.back, {light.data(), light.data() + bands}, shot.colours, fraction);
}

// The parts of pixels that edges pass through, the pixels that see the sky, and the scratch of one thread.
struct PixelParts {
  EdgePixels edges;
  SkyPixels sky;
  std::vector<Vec3> samples;  // of the current pixel
  std::vector<float> light;   // of radiance_at()
};

// Returns the number of parts of a pixel sampled on a grid of rows x rows cells.
std::size_t parts_per_pixel(int rows) { return std::min(max_parts, static_cast<std::size_t>(rows * rows)); }

int rows_on_edges(const RenderOptions& options) {
  const auto rows = options.samples_per_side;
  return rows < fine_rows ? std::min(2 * rows, fine_rows) : rows;
}

// The means of `count` equal parts of the samples in ascending luminance, so that one part at most has
// samples of both sides of an edge. A sample on the border of two parts counts in both, by fractions.
void append_parts(std::vector<Vec3>& samples, std::size_t count, std::vector<Vec3>& parts) {
  std::stable_sort(samples.begin(), samples.end(),
                   [](const Vec3& a, const Vec3& b) { return luminance(a) < luminance(b); });
  const auto width = static_cast<double>(samples.size()) / static_cast<double>(count);
  for (std::size_t part = 0; part < count; ++part) {
    const auto low = width * static_cast<double>(part);
    const auto high = width * static_cast<double>(part + 1);
    Vec3d sum(0.0);
    for (auto s = static_cast<std::size_t>(low); s < samples.size() && static_cast<double>(s) < high; ++s) {
      const auto at = static_cast<double>(s);
      sum += (std::min(high, at + 1.0) - std::max(low, at)) * Vec3d(samples[s]);
    }
    parts.push_back(Vec3(sum / width));
  }
}

void add_if_edge(std::uint32_t pixel, int rows, PixelParts& parts) {
  float darkest = std::numeric_limits<float>::infinity(), brightest = 0.0f;
  for (const auto& sample : parts.samples) {
    const auto L = luminance(sample);
    darkest = std::min(darkest, L);
    brightest = std::max(brightest, L);
  }
  if (!(brightest > edge_contrast * darkest)) return;
  parts.edges.pixels.push_back(pixel);
  append_parts(parts.samples, parts_per_pixel(rows), parts.edges.radiance);
}

// The mean over the pixel's square (a box filter), one jittered sample in each cell of a grid of side x side.
// The samples of grids of different sizes are independent.
Vec3 pixel_radiance(const Shot& shot, std::uint32_t pixel, int side, PixelParts& parts) {
  const auto width = static_cast<std::uint32_t>(shot.options.width);
  const auto x = static_cast<int>(pixel % width), y = static_cast<int>(pixel / width);
  const bool is_coarse = side == shot.options.samples_per_side;
  const auto key = stream_key(shot.options.seed, is_coarse ? 0 : 1, pixel);
  Vec3d sum(0.0), shown(0.0);
  int of_sky = 0;
  parts.samples.clear();
  for (int cell = 0; cell < side * side; ++cell) {
    const auto ray = shot.pinhole.ray_in_cell(x, y, key, cell, side);
    const auto hit = shot.tracer.nearest(ray);
    const auto lamp = shot.luminaires.empty() ? std::nullopt : shot.luminaires.first(ray, hit.distance);
    const auto passed = shot.panes.along(ray, lamp ? lamp->distance : hit.distance);
    const auto radiance = passed * (lamp ? lamp->radiance : radiance_at(shot, ray, hit, parts.light));
    const auto displayed = hit || lamp ? radiance : passed * shot.sky.at(Vec3d(ray.direction));
    sum += radiance;
    shown += displayed;
    of_sky += hit || lamp ? 0 : 1;
    parts.samples.push_back(in_gamut(displayed));
  }
  const double samples = side * side;
  add_if_edge(pixel, side, parts);
  if (of_sky > 0 && is_coarse && shot.patches.has_sky())
    add_sky({pixel, of_sky / samples, shown / samples}, parts.sky);
  return in_gamut(sum / samples);
}

void append(const EdgePixels& more, EdgePixels& edges) {
  edges.pixels.insert(edges.pixels.end(), more.pixels.begin(), more.pixels.end());
  edges.radiance.insert(edges.radiance.end(), more.radiance.begin(), more.radiance.end());
}

// The same edges, ascending.
EdgePixels sorted(const EdgePixels& edges) {
  std::vector<std::size_t> order(edges.pixels.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return edges.pixels[a] < edges.pixels[b]; });
  EdgePixels result{edges.parts, {}, {}};
  for (const auto i : order) {
    result.pixels.push_back(edges.pixels[i]);
    const auto first = edges.radiance.begin() + static_cast<std::ptrdiff_t>(i * edges.parts);
    result.radiance.insert(result.radiance.end(), first, first + static_cast<std::ptrdiff_t>(edges.parts));
  }
  return result;
}

// Renders pixels with edges again, with more samples, and the pixels around those where these find an edge,
// until it is followed to its end: a thin line crosses pixels in which no coarse sample met it.
class EdgeRefiner {
 public:
  EdgeRefiner(const Shot& shot, Picture& picture)
      : shot_(shot),
        picture_(picture),
        rows_(rows_on_edges(shot.options)),
        is_taken_(picture.radiance.pixels.size(), 0),
        fine_{parts_per_pixel(rows_), {}, {}} {}

  // Returns false where the monitor stops it; then some pixels have more samples than others.
  bool refine(const Context& context) {
    auto front = std::move(picture_.edges.pixels);
    for (const auto pixel : front) is_taken_[pixel] = 1;
    const auto batch = std::max<std::size_t>(1, rays_between_calls / static_cast<std::size_t>(rows_ * rows_));
    bool is_stopped = false;
    for (int batches = 0; !front.empty() && !is_stopped;) {
      std::vector<std::uint32_t> found;
      for (std::size_t begin = 0; begin < front.size() && !is_stopped; begin += batch) {
        refine(std::span(front).subspan(begin, std::min(batch, front.size() - begin)), found, context);
        const auto done = 1.0 - (1.0 - coarse_part) / (2.0 + batches++);
        is_stopped = context.report({"picture", done, picture_.rays}) == Next::stop;
      }
      front = around(found);
    }
    picture_.edges = sorted(fine_);
    return !is_stopped;
  }

 private:
  void refine(std::span<const std::uint32_t> pixels, std::vector<std::uint32_t>& found,
              const Context& context) {
    std::vector<PixelParts> chunks((pixels.size() + pixels_per_chunk - 1) / pixels_per_chunk);
    context.for_chunks(pixels.size(), pixels_per_chunk, [&](std::size_t begin, std::size_t end, int) {
      auto& parts = chunks[begin / pixels_per_chunk];
      parts.light.resize(2 * shot_.colours.bands());
      for (auto i = begin; i < end; ++i)
        picture_.radiance.pixels[pixels[i]] = pixel_radiance(shot_, pixels[i], rows_, parts);
    });
    picture_.rays += pixels.size() * static_cast<std::size_t>(rows_ * rows_);
    for (const auto& chunk : chunks) {
      append(chunk.edges, fine_);
      found.insert(found.end(), chunk.edges.pixels.begin(), chunk.edges.pixels.end());
    }
  }

  // The neighbours of these pixels that are not taken yet; takes them.
  std::vector<std::uint32_t> around(const std::vector<std::uint32_t>& pixels) {
    std::vector<std::uint32_t> next;
    const auto width = shot_.options.width, height = shot_.options.height;
    for (const auto pixel : pixels) {
      const auto x = static_cast<int>(pixel) % width, y = static_cast<int>(pixel) / width;
      for (auto v = std::max(0, y - 1); v <= std::min(height - 1, y + 1); ++v)
        for (auto u = std::max(0, x - 1); u <= std::min(width - 1, x + 1); ++u) {
          const auto other = static_cast<std::uint32_t>(v * width + u);
          if (is_taken_[other] != 0) continue;
          is_taken_[other] = 1;
          next.push_back(other);
        }
    }
    return next;
  }

  const Shot& shot_;
  Picture& picture_;
  int rows_;
  std::vector<std::uint8_t> is_taken_;
  EdgePixels fine_;
};

}  // namespace

Picture render_picture(const PatchSet& patches, const SmoothLight& light, const Tracer& tracer,
                       const Camera& camera, const RenderOptions& options, const Context& context) {
  check(patches, light, options);
  const Pinhole pinhole(camera, options.width, options.height);
  const auto colours = patches.colours();
  const DisplayedSky sky(patches, camera);
  const PaneColours panes(patches, colours);
  const FineColours fine(patches, context);
  const VisibleLuminaires luminaires(patches, colours);
  const Shot shot{patches, light, tracer, pinhole, options, colours, fine, luminaires, sky, panes};
  Picture picture{
      Image(options.width, options.height), {parts_per_pixel(options.samples_per_side), {}, {}}, {}, 0};
  const bool has_fine = rows_on_edges(options) > options.samples_per_side;

  const auto width = static_cast<std::size_t>(options.width);
  const auto height = static_cast<std::size_t>(options.height);
  const auto rays_per_row =
      width * static_cast<std::size_t>(options.samples_per_side * options.samples_per_side);
  const auto band_rows = std::max<std::size_t>(1, rays_between_calls / rays_per_row);
  for (std::size_t row = 0; row < height; row += band_rows) {
    const Progress progress{
        "picture", (has_fine ? coarse_part : 1.0) * static_cast<double>(row) / static_cast<double>(height),
        row * rays_per_row};
    if (context.report(progress) == Next::stop) return picture;
    const auto first = row * width;
    const auto count = std::min(band_rows, height - row) * width;
    std::vector<PixelParts> chunks((count + pixels_per_chunk - 1) / pixels_per_chunk);
    context.for_chunks(count, pixels_per_chunk, [&](std::size_t begin, std::size_t end, int) {
      auto& parts = chunks[begin / pixels_per_chunk];
      parts.light.resize(2 * colours.bands());
      for (auto i = first + begin; i < first + end; ++i)
        picture.radiance.pixels[i] =
            pixel_radiance(shot, static_cast<std::uint32_t>(i), options.samples_per_side, parts);
    });
    for (const auto& chunk : chunks) {
      append(chunk.edges, picture.edges);
      append(chunk.sky, picture.sky);
    }
  }
  picture.rays = height * rays_per_row;
  if (has_fine && !EdgeRefiner(shot, picture).refine(context)) return picture;
  context.report({"picture", 1.0, picture.rays});
  return picture;
}

Image render(const PatchSet& patches, const SmoothLight& light, const Tracer& tracer, const Camera& camera,
             const RenderOptions& options, const Context& context) {
  return render_picture(patches, light, tracer, camera, options, context).radiance;
}

Image render(const Baked& baked, const Camera& camera, const RenderOptions& options, const Context& context) {
  const Tracer tracer(baked.patches, context);
  const auto light = make_smooth_light(baked.patches, baked.solution, {.lights_hidden = true}, context);
  return render(baked.patches, light, tracer, camera, options, context);
}

}  // namespace luxel
