// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/view_score.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>

#include "luxel/render/pinhole.h"

namespace luxel {
namespace {

// Entropy of counts over that of `classes` equal counts, at most 1.
double evenness(std::span<const double> counts, double classes) {
  double total = 0.0;
  for (const auto c : counts) total += c;
  if (!(total > 0.0)) return 0.0;
  double entropy = 0.0;
  for (const auto c : counts)
    if (c > 0.0) entropy -= c / total * std::log(c / total);
  return std::min(1.0, entropy / std::log(classes));
}

// 0 to 5: the axis direction nearest to the normal of the visible side.
std::size_t facing(const Vec3& normal) {
  const auto a = glm::abs(normal);
  const std::size_t axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
  return 2 * axis + (normal[static_cast<int>(axis)] < 0.0f ? 1 : 0);
}

double directions_variety(const Subject& subject, const std::vector<Hit>& hits) {
  std::array<double, 6> counts{};
  for (const auto& hit : hits) {
    const auto& n = subject.patches.normal[hit.patch];
    counts[facing(hit.back ? -n : n)] += 1.0;
  }
  return evenness(counts, 5.0);
}

double materials_variety(const Subject& subject, const std::vector<Hit>& hits) {
  std::map<MaterialId, double> counts;
  for (const auto& hit : hits) counts[subject.patches.material[hit.patch]] += 1.0;
  std::vector<double> list;
  for (const auto& [material, count] : counts) list.push_back(count);
  return evenness(list, 8.0);
}

// Evenness over bins of distance, a factor sqrt(2) each.
double depth_variety(const std::vector<Hit>& hits, float depth) {
  std::array<double, 16> counts{};
  for (const auto& hit : hits) {
    const auto bin = 8.0f + 2.0f * std::log2(std::max(hit.distance / depth, 1e-3f));
    counts[static_cast<std::size_t>(std::clamp(bin, 0.0f, 15.0f))] += 1.0;
  }
  return evenness(counts, 6.0);
}

float geometric_mean_distance(const std::vector<Hit>& hits) {
  double sum = 0.0;
  for (const auto& hit : hits) sum += std::log(std::max(1e-30, static_cast<double>(hit.distance)));
  return hits.empty() ? 0.0f : static_cast<float>(std::exp(sum / static_cast<double>(hits.size())));
}

bool differ(const Subject& subject, const Hit& a, const Hit& b) {
  if (!a || !b) return a || b;
  return subject.patches.material[a.patch] != subject.patches.material[b.patch] ||
         glm::dot(subject.patches.normal[a.patch], subject.patches.normal[b.patch]) < 0.8f ||
         std::max(a.distance, b.distance) > 1.5f * std::min(a.distance, b.distance);
}

// pixels: row by row.
double detail_of(const Subject& subject, std::span<const Hit> pixels, std::size_t columns) {
  std::size_t edges = 0;
  for (std::size_t i = columns; i < pixels.size(); ++i) {
    if (differ(subject, pixels[i], pixels[i - columns])) ++edges;
    if (i % columns > 0 && differ(subject, pixels[i], pixels[i - 1])) ++edges;
  }
  return static_cast<double>(edges) / (2.0 * static_cast<double>(pixels.size()));
}

// Adds one pixel to the fractions, which are not yet divided by the number of pixels. solid_angle: of the
// pixel, sr.
void add_hit(const Subject& subject, const Ray& ray, const Hit& hit, double solid_angle, double pixels,
             ViewFacts& facts) {
  const auto side = hit.side();
  if (subject.sides.glaring[side.index()]) facts.glare += 1.0;
  if (!subject.sides.lit(side)) return;
  const auto brightness = static_cast<double>(subject.sides.brightness[side.index()]);
  facts.lit += 1.0;
  facts.bright += brightness;
  // Limits the area that one pixel represents; else a distant floor at a grazing angle would dominate.
  const auto cosine = std::abs(glm::dot(ray.direction, subject.patches.normal[hit.patch]));
  const auto distance = static_cast<double>(hit.distance);
  const auto area = distance * distance * solid_angle / std::max(0.1, static_cast<double>(cosine));
  facts.coverage += std::min(pixels * area * brightness / subject.sides.lit_area, 4.0);
}

// Only steep surfaces count: the floor may begin at the viewer's feet.
double near_count(const Subject& subject, std::span<const Hit> hits, float depth) {
  const auto close = std::max(0.35f * depth, 0.004f * subject.diagonal);
  return static_cast<double>(std::count_if(hits.begin(), hits.end(), [&](const Hit& hit) {
    const auto level = std::abs(glm::dot(subject.patches.normal[hit.patch], subject.up)) > 0.7f;
    return hit.distance < (level ? 0.4f * close : close);
  }));
}

// Weight of black beside the walls of a room; an open scene has no other surroundings.
double gap_weight(double openness) { return std::max(0.0, 1.0 - 2.0 * openness); }

// The fraction of rays through the outline of the picture that meet nothing. A thumbnail's pixels have their
// centres further inside, and would not show a narrow black strip beside a wall.
double gap_at_outline(const Subject& subject, const Pinhole& pinhole, int columns, int rows) {
  if (subject.patches.has_sky() || gap_weight(subject.openness) == 0.0) return 0.0;
  double missed = 0.0;
  const auto test = [&](double x, double y) {
    missed += subject.tracer.nearest(pinhole.ray(x, y)) ? 0.0 : 1.0;
  };
  for (int x = 0; x < columns; ++x) {
    test(x + 0.5, 0.0);
    test(x + 0.5, rows);
  }
  for (int y = 0; y < rows; ++y) {
    test(0.0, y + 0.5);
    test(columns, y + 0.5);
  }
  return missed / (2.0 * (columns + rows));
}

}  // namespace

ViewFacts look(const Subject& subject, const Camera& camera, int rows) {
  const auto columns =
      std::clamp(static_cast<int>(std::lround(static_cast<float>(rows) * subject.aspect)), 3, 4 * rows);
  const Pinhole pinhole(camera, columns, rows);
  const auto pixels = static_cast<double>(rows * columns);
  const auto pixel_side = 2.0 * tangent_of_degrees(0.5 * static_cast<double>(camera.vertical_fov)) / rows;
  const auto forward = glm::normalize(camera.target - camera.eye);

  const auto margin = std::max(1, rows / 12);
  const auto is_border = [&](int x, int y) {
    return std::min(x, columns - 1 - x) < margin || std::min(y, rows - 1 - y) < margin;
  };

  ViewFacts facts;
  std::vector<Hit> picture;
  std::vector<Hit> hits;
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const auto ray = pinhole.ray(x + 0.5, y + 0.5);
      const auto& hit = picture.emplace_back(subject.tracer.nearest(ray));
      if (!hit) continue;
      hits.push_back(hit);
      facts.lopsided += x < columns / 2 ? 1.0 : x >= columns - columns / 2 ? -1.0 : 0.0;
      if (is_border(x, y)) facts.border += 1.0;
      const auto cosine = static_cast<double>(glm::dot(ray.direction, forward));
      add_hit(subject, ray, hit, pixel_side * pixel_side * cosine * cosine * cosine, pixels, facts);
    }
  }
  facts.detail = detail_of(subject, picture, static_cast<std::size_t>(columns));
  facts.depth = geometric_mean_distance(hits);
  facts.near = near_count(subject, hits, facts.depth) / pixels;
  facts.border /= pixels - (columns - 2.0 * margin) * (rows - 2.0 * margin);
  facts.gap = gap_at_outline(subject, pinhole, columns, rows);
  facts.lopsided = std::abs(facts.lopsided) / pixels;
  facts.rise = static_cast<double>(glm::dot(forward, subject.up));
  facts.empty = 1.0 - static_cast<double>(hits.size()) / pixels;
  for (auto* fraction : {&facts.bright, &facts.lit, &facts.glare, &facts.coverage}) *fraction /= pixels;
  facts.variety = (directions_variety(subject, hits) + materials_variety(subject, hits) +
                   depth_variety(hits, facts.depth)) /
                  3.0;
  return facts;
}

double score(const ViewFacts& f, double openness) {
  const auto beyond = [](double fraction, double allowed) { return std::max(0.0, fraction - allowed); };
  const auto allowed = std::min(0.6, openness);
  const auto filled = 1.0 - std::min(f.empty, allowed);
  // In the open, an object cut off at the border lowers the score; in a room the picture always ends on
  // walls.
  const auto open = beyond(openness, 0.5);  // 0.5 of a solid, which shows its top to views from above
  const auto cut_off = 8.0 * open * open * f.border;
  return 0.5 * std::log(f.bright / filled + 0.02) + 0.6 * std::log(f.coverage + 0.01) + 0.8 * f.variety +
         1.5 * std::min(f.detail, 0.4) - 3.0 * beyond(f.near, 0.03) - 3.0 * beyond(f.glare, 0.10) -
         2.0 * beyond(f.empty, allowed) - 1.5 * f.lopsided - 1.5 * cut_off - gap_weight(openness) * f.gap -
         1.5 * beyond(f.rise, 0.02) - (1.0 - 2.0 * open) * beyond(-f.rise, 0.13);
}

}  // namespace luxel
