// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/shadow_parts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "luxel/lamps/shadow_doubles.h"
#include "luxel/lamps/shadow_test.h"
#include "luxel/patch/flat_triangle.h"

namespace luxel {
namespace {

constexpr double from_end = 2.0;        // first and last pair of a part, in reach from its ends
constexpr double pairs_per_edge = 4.0;  // per `detail` of a part's length
constexpr double max_pairs = 24.0;      // per part
constexpr int bisections = 12;

// A segment in the plane of the triangle, in a basis of two unit vectors, m.
struct Segment {
  std::array<glm::dvec2, 2> ends;
  std::uint32_t light;
  bool is_contact;
  double low() const { return std::min(ends[0].x, ends[1].x); }
  double high() const { return std::max(ends[0].x, ends[1].x); }
};

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

// Where segments cross: [shadow] fractions of its length, in ascending order, with 0 and 1.
std::vector<std::vector<double>> crossings(const FlatTriangle& plane, std::span<const EdgeShadow> shadows,
                                           std::span<const ContactLine> contacts, double slack) {
  const auto x = glm::normalize(plane.corner[1] - plane.corner[0]);
  const auto y = glm::cross(plane.normal, x);
  const auto at = [&](const Vec3d& p) {
    const auto d = p - plane.corner[0];
    return glm::dvec2(glm::dot(d, x), glm::dot(d, y));
  };
  std::vector<Segment> segments;
  for (const auto& s : shadows) segments.push_back({{at(s.ends[0]), at(s.ends[1])}, s.light, false});
  for (const auto& c : contacts) segments.push_back({{at(c.ends[0]), at(c.ends[1])}, 0, true});
  std::vector<std::size_t> order(segments.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return segments[a].low() < segments[b].low(); });

  std::vector<std::vector<double>> found(shadows.size(), {0.0, 1.0});
  const auto add = [&](std::size_t i, double fraction) {
    const auto length = glm::distance(segments[i].ends[0], segments[i].ends[1]);
    if (i < shadows.size() && fraction * length > slack && (1.0 - fraction) * length > slack)
      found[i].push_back(fraction);
  };
  for (std::size_t n = 0; n < order.size(); ++n)
    for (std::size_t m = n + 1; m < order.size(); ++m) {
      const auto i = order[n], j = order[m];
      const auto &a = segments[i], &b = segments[j];
      if (b.low() > a.high() + slack) break;
      if (a.is_contact ? b.is_contact : !b.is_contact && a.light != b.light) continue;
      const auto u = a.ends[1] - a.ends[0], v = b.ends[1] - b.ends[0], w = b.ends[0] - a.ends[0];
      const auto area = cross(u, v);
      if (std::fabs(area) <= 1e-9 * glm::length(u) * glm::length(v)) continue;
      const auto s = cross(w, v) / area, t = cross(w, u) / area;
      const auto off_a = slack / glm::length(u), off_b = slack / glm::length(v);
      if (s < -off_a || s > 1.0 + off_a || t < -off_b || t > 1.0 + off_b) continue;
      add(i, s);
      add(j, t);
    }
  for (auto& f : found) std::sort(f.begin(), f.end());
  return found;
}

// Tests the parts of one shadow.
class Tester {
 public:
  Tester(const ShadowTest& test, double length, const ShadowReceivers::Lengths& lengths)
      : test_(test), length_(length), lengths_(lengths) {}

  // The intervals along which light ends, of parts that meet joined.
  std::vector<Interval> intervals(const std::vector<double>& cuts) const {
    std::vector<Interval> found;
    const auto add = [&](double begin, double end) {
      if (!found.empty() && begin <= found.back().end)
        found.back().end = std::max(found.back().end, end);
      else
        found.push_back({begin, end});
    };
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      const auto begin = cuts[i], end = cuts[i + 1];
      if ((end - begin) * length_ < shortest_tested * lengths_.reach) {
        // Too short to be tested: joins two that are true.
        const bool is_inner = i > 0 && i + 2 < cuts.size();
        if (is_inner && !found.empty() && found.back().end == begin && starts_true(cuts, i + 1))
          add(begin, end);
        continue;
      }
      add_true(begin, end, add);
    }
    return found;
  }

 private:
  bool starts_true(const std::vector<double>& cuts, std::size_t i) const {
    while (i + 2 < cuts.size() && (cuts[i + 1] - cuts[i]) * length_ < shortest_tested * lengths_.reach) ++i;
    return test_.divides(
        std::min(cuts[i] + from_end * lengths_.reach / length_, 0.5 * (cuts[i] + cuts[i + 1])));
  }

  template <typename Add>
  void add_true(double begin, double end, const Add& add) const {
    const auto pairs =
        std::clamp(std::ceil(pairs_per_edge * (end - begin) * length_ / lengths_.detail), 3.0, max_pairs);
    const auto inset = from_end * lengths_.reach / length_;
    const auto at = [&](double i) { return begin + inset + (end - begin - 2.0 * inset) * i / (pairs - 1.0); };
    bool was = test_.divides(at(0.0));
    auto from = begin;
    for (double i = 1.0; i < pairs; i += 1.0) {
      const bool is = test_.divides(at(i));
      if (is != was) {
        const auto change = moved_to_end(bisect(at(i - 1.0), at(i), was), begin, end);
        if (was) add(from, change);
        from = change;
      }
      was = is;
    }
    if (was) add(from, end);
  }

  // Close to an end, beside the boundary of the triangle, pairs are too narrow to tell.
  double moved_to_end(double change, double begin, double end) const {
    const auto close = shortest_tested * lengths_.reach / length_;
    if (change - begin < close) return begin;
    return end - change < close ? end : change;
  }

  double bisect(double low, double high, bool at_low) const {
    for (int i = 0; i < bisections; ++i) {
      const auto middle = 0.5 * (low + high);
      (test_.divides(middle) == at_low ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

  const ShadowTest& test_;
  double length_;  // m
  const ShadowReceivers::Lengths& lengths_;
};

}  // namespace

std::vector<EdgeShadow> true_parts(const PatchSet& triangles, const Tracer& tracer,
                                   std::span<const EdgeShadow> shadows, std::span<const ContactLine> contacts,
                                   const ShadowReceivers::Lengths& lengths) {
  if (shadows.empty()) return {};
  const auto points = triangles.points(shadows[0].triangle);
  const FlatTriangle plane(points);
  const auto cuts = crossings(plane, shadows, contacts, slack_roundings * coordinate_rounding(points));
  std::vector<EdgeShadow> parts;
  for (std::size_t i = 0; i < shadows.size(); ++i) {
    const ShadowTest test(triangles, tracer, shadows[i], lengths.reach);
    const auto length = glm::distance(shadows[i].ends[0], shadows[i].ends[1]);
    for (const auto& interval : Tester(test, length, lengths).intervals(cuts[i]))
      if ((interval.end - interval.begin) * length > shortest_line * lengths.reach)
        parts.push_back(part_of(shadows[i], interval));
  }
  return without_doubles(std::move(parts), lengths.reach);
}

}  // namespace luxel
