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

// Entropy of counts over that of `classes` alike, at most 1.
double evenness(std::span<const double> counts, double classes) {
  double total = 0.0;
  for (const auto c : counts) total += c;
  if (!(total > 0.0)) return 0.0;
  double entropy = 0.0;
  for (const auto c : counts)
    if (c > 0.0) entropy -= c / total * std::log(c / total);
  return std::min(1.0, entropy / std::log(classes));
}

// 0 to 5: which of the six axis directions the side that is seen faces most.
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

// Bins of a factor sqrt(2) in distance.
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

}  // namespace

ViewFacts look(const Subject& subject, const Camera& camera, int rows) {
  const auto columns =
      std::clamp(static_cast<int>(std::lround(static_cast<float>(rows) * subject.aspect)), 3, 4 * rows);
  const Pinhole pinhole(camera, columns, rows);
  const auto pixels = static_cast<double>(rows * columns);
  const auto pixel_side = 2.0 * tangent_of_degrees(0.5 * static_cast<double>(camera.vertical_fov)) / rows;
  const auto forward = glm::normalize(camera.target - camera.eye);

  ViewFacts facts;
  std::vector<Hit> hits;
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const auto ray = pinhole.ray(x + 0.5, y + 0.5);
      const auto hit = subject.tracer.nearest(ray);
      if (!hit) continue;
      hits.push_back(hit);
      const auto side = std::size_t{2} * hit.patch + (hit.back ? 1 : 0);
      if (!hit.back && subject.patches.material_of(hit.patch).is_lamp()) facts.lamp += 1.0 / pixels;
      if (!subject.sides.lit(side)) continue;
      facts.lit += 1.0 / pixels;
      facts.bright += static_cast<double>(subject.sides.brightness[side]) / pixels;
      // The surface a pixel shows: distance² solid angle / cosine. One pixel may not stand for much of the
      // scene, or a far floor seen at a grazing angle would outweigh the picture.
      const auto along = static_cast<double>(glm::dot(ray.direction, forward));
      const auto cosine = std::max(
          0.1, static_cast<double>(std::abs(glm::dot(ray.direction, subject.patches.normal[hit.patch]))));
      const auto side_length = pixel_side * static_cast<double>(hit.distance);
      const auto area = side_length * side_length * along * along * along / cosine;
      facts.coverage += std::min(area / subject.sides.lit_area, 4.0 / pixels);
    }
  }
  facts.empty = 1.0 - static_cast<double>(hits.size()) / pixels;
  if (hits.empty()) return facts;
  facts.depth = geometric_mean_distance(hits);
  const auto close = std::max(0.22f * facts.depth, 0.004f * subject.diagonal);
  for (const auto& hit : hits) facts.near += hit.distance < close ? 1.0 / pixels : 0.0;
  facts.variety = (directions_variety(subject, hits) + materials_variety(subject, hits) +
                   depth_variety(hits, facts.depth)) /
                  3.0;
  return facts;
}

double score(const ViewFacts& f) {
  const auto beyond = [](double share, double allowed) { return std::max(0.0, share - allowed); };
  return std::log(f.bright + 0.02) + 0.35 * std::log(f.coverage + 0.005) + 0.8 * f.variety -
         2.0 * beyond(f.near, 0.03) - 3.0 * beyond(f.lamp, 0.10) - 1.0 * beyond(f.empty, 0.05) -
         1.5 * beyond(f.empty, 0.25);
}

}  // namespace luxel
