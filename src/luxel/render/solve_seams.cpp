// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/solve_seams.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/conjugate_gradients.h"
#include "luxel/core/error.h"
#include "luxel/render/footprint.h"

namespace luxel {
namespace {

using Numbers = std::vector<double>;

// One point of a seam: the value read in one chart minus that read in the other.
struct Row {
  std::array<std::uint32_t, 8> texel{};  // index into the unknowns
  std::array<double, 8> weight{};
};

// The texels that seams read, and the equations over them.
class Seams {
 public:
  Seams(const std::vector<SeamPlace>& places, int page_size) {
    const auto per_page = static_cast<std::size_t>(page_size) * static_cast<std::size_t>(page_size);
    std::vector<std::array<std::size_t, 8>> named(places.size());
    rows_.resize(places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
      for (std::size_t s = 0; s < 2; ++s) {
        const auto& on = places[i].sides[s];
        const Footprint read(on.at, page_size);
        for (std::size_t k = 0; k < 4; ++k) {
          named[i][4 * s + k] = on.page * per_page + read.texel[k];
          rows_[i].weight[4 * s + k] = static_cast<double>(s == 0 ? read.weight[k] : -read.weight[k]);
          texels_.push_back(named[i][4 * s + k]);
        }
      }
    std::sort(texels_.begin(), texels_.end());
    texels_.erase(std::unique(texels_.begin(), texels_.end()), texels_.end());
    for (std::size_t i = 0; i < places.size(); ++i)
      for (std::size_t k = 0; k < 8; ++k)
        rows_[i].texel[k] = static_cast<std::uint32_t>(
            std::lower_bound(texels_.begin(), texels_.end(), named[i][k]) - texels_.begin());
  }

  const std::vector<std::size_t>& texels() const { return texels_; }  // index: page * texels per page + texel

  Numbers differences(const Numbers& x) const {
    Numbers result(rows_.size(), 0.0);
    for (std::size_t i = 0; i < rows_.size(); ++i)
      for (std::size_t k = 0; k < 8; ++k) result[i] += rows_[i].weight[k] * x[rows_[i].texel[k]];
    return result;
  }
  // The transpose.
  Numbers back(const Numbers& differences) const {
    Numbers result(texels_.size(), 0.0);
    for (std::size_t i = 0; i < rows_.size(); ++i)
      for (std::size_t k = 0; k < 8; ++k) result[rows_[i].texel[k]] += rows_[i].weight[k] * differences[i];
    return result;
  }

 private:
  std::vector<std::size_t> texels_;
  std::vector<Row> rows_;
};

double dot(const Numbers& a, const Numbers& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

// Solves (S'S + w) d = -S'S x for the change d of the texels x that minimises |S (x + d)|² + w |d|². Returns
// the number of steps. may_step(step): called before each step.
template <typename MayStep>
int change(const Seams& seams, const Numbers& x, const SeamOptions& options, Numbers& d,
           const MayStep& may_step) {
  constexpr double as_good = 1e-10;  // relative squared residual at which the iteration ends
  const auto apply = [&](const Numbers& v, Numbers& result) {
    result = seams.back(seams.differences(v));
    for (std::size_t i = 0; i < v.size(); ++i) result[i] += options.weight_of_light * v[i];
  };
  d.assign(x.size(), 0.0);
  auto residual = seams.back(seams.differences(x));
  for (auto& r : residual) r = -r;
  const auto as_it_is = [](const Numbers& v, Numbers& result) { result = v; };
  return conjugate_gradients(d, std::move(residual), {options.max_steps, as_good},
                             LinearSystem{apply, as_it_is, dot},
                             [&](int step, const Numbers&) { return may_step(step); });
}

}  // namespace

std::vector<SeamPlace> find_seam_places(const Charts& charts, const Atlas& atlas) {
  constexpr double places_per_texel = 2.0;
  constexpr float same_place = 1e-2f;  // texels; the edges of both charts coincide, so there is no seam
  std::vector<SeamPlace> places;
  for (const auto& edge : charts.edges) {
    const auto side_a = edge.halves[0].side, side_b = edge.halves[1].side;
    if (!edge.smooth || !atlas.has(side_a) || !atlas.has(side_b)) continue;
    if (charts.charts[charts.of_side[side_a.index()]].is_point ||
        charts.charts[charts.of_side[side_b.index()]].is_point)
      continue;
    std::array<std::array<Vec2, 2>, 2> ends;  // [half][end], texels
    double length = 0.0;
    for (std::size_t h = 0; h < 2; ++h) {
      const auto& half = edge.halves[h];
      const auto &a = atlas.corners[half.side.index()][half.edge],
                 &b = atlas.corners[half.side.index()][(half.edge + 1) % 3];
      ends[h] = {a + half.from * (b - a), a + half.to * (b - a)};
      length = std::max(length, static_cast<double>(glm::length(ends[h][1] - ends[h][0])));
    }
    if (atlas.page_of(side_a) == atlas.page_of(side_b) && glm::length(ends[0][0] - ends[1][0]) < same_place &&
        glm::length(ends[0][1] - ends[1][1]) < same_place)
      continue;
    const auto count = std::max(1, static_cast<int>(std::ceil(places_per_texel * length)));
    for (int i = 0; i < count; ++i) {
      const auto fraction = (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
      SeamPlace place;
      for (std::size_t h = 0; h < 2; ++h)
        place.sides[h] = {atlas.page_of(edge.halves[h].side),
                          ends[h][0] + fraction * (ends[h][1] - ends[h][0])};
      places.push_back(place);
    }
  }
  return places;
}

SeamReport solve_seams(const Charts& charts, Lightmap& lightmap, const SeamOptions& options,
                       const Context& context) {
  if (!(options.weight_of_light > 0.0))
    throw InputError(
        fmt::format("at seams the light must weigh more than 0, but it does {}", options.weight_of_light));
  const auto places = find_seam_places(charts, lightmap.atlas);
  SeamReport report;
  report.places = places.size();
  if (places.empty()) return report;

  const Seams seams(places, lightmap.atlas.page_size);
  const auto per_page = lightmap.pages[0].irradiance.pixels.size();
  const auto pixel = [&](std::size_t texel) -> Vec3& {
    return lightmap.pages[texel / per_page].irradiance.pixels[texel % per_page];
  };
  double before = 0.0, after = 0.0, light = 0.0;
  for (int c = 0; c < 3; ++c) {
    Numbers x(seams.texels().size()), d;
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = static_cast<double>(pixel(seams.texels()[i])[c]);
    const auto found = seams.differences(x);
    const auto next_step = [&](int step) {
      const auto done = (c + static_cast<double>(step) / options.max_steps) / 3.0;
      report.stopped = report.stopped || context.report({"seams", done}) == Next::stop;
      return !report.stopped;
    };
    report.steps = std::max(report.steps, change(seams, x, options, d, next_step));
    if (report.stopped) return report;
    before += dot(found, found) / static_cast<double>(found.size());
    light += dot(x, x) / static_cast<double>(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i] = std::max(0.0, x[i] + d[i]);
      pixel(seams.texels()[i])[c] = static_cast<float>(x[i]);
    }
    const auto left = seams.differences(x);
    after += dot(left, left) / static_cast<double>(left.size());
  }
  if (light > 0.0) {
    report.difference_before = std::sqrt(before / light);
    report.difference_after = std::sqrt(after / light);
  }
  return report;
}

}  // namespace luxel
