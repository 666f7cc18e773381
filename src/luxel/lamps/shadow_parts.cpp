// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/shadow_parts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "luxel/lamps/shadow_test.h"
#include "luxel/patch/flat_triangle.h"

namespace luxel {
namespace {

constexpr double from_end = 2.0;         // first and last pair of a part, in reach from its ends
constexpr double shortest_tested = 6.0;  // in reach: a shorter part is as its neighbours are
constexpr double pairs_per_edge = 4.0;   // per max_edge of a part's length
constexpr double max_pairs = 24.0;       // per part
constexpr int bisections = 12;
constexpr double beside = 2.0;          // in reach: lines that are nearer to each other are one
constexpr double parallel_sine = 0.05;  // between lines that may be one
constexpr double shortest_left = 4.0;   // in reach: what two lines leave of each other

// A segment in the plane of the triangle, in a basis of two unit vectors, m.
struct Segment {
  std::array<glm::dvec2, 2> ends;
  std::uint32_t light;
  bool is_contact;
  double low() const { return std::min(ends[0].x, ends[1].x); }
  double high() const { return std::max(ends[0].x, ends[1].x); }
};

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

EdgeShadow part_of(const EdgeShadow& shadow, const Interval& interval) {
  auto part = shadow;
  const auto along = shadow.ends[1] - shadow.ends[0];
  part.ends = {shadow.ends[0] + interval.begin * along, shadow.ends[0] + interval.end * along};
  if (interval.end == 1.0) part.ends[1] = shadow.ends[1];
  part.weight = shadow.weight * (interval.end - interval.begin);
  return part;
}

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
        std::clamp(std::ceil(pairs_per_edge * (end - begin) * length_ / lengths_.max_edge), 3.0, max_pairs);
    const auto inset = from_end * lengths_.reach / length_;
    const auto at = [&](double i) { return begin + inset + (end - begin - 2.0 * inset) * i / (pairs - 1.0); };
    bool was = test_.divides(at(0.0));
    auto from = begin;
    for (double i = 1.0; i < pairs; i += 1.0) {
      const bool is = test_.divides(at(i));
      if (is != was) {
        const auto change = bisect(at(i - 1.0), at(i), was);
        if (was) add(from, change);
        from = change;
      }
      was = is;
    }
    if (was) add(from, end);
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

// The interval of a part that lies within `distance` of another one, which is nearly parallel.
Interval covered(const EdgeShadow& part, const EdgeShadow& by, double distance) {
  constexpr Interval nothing{1.0, 0.0};
  const auto along = by.ends[1] - by.ends[0];
  const auto length = glm::length(along);
  const auto unit = along / length;
  const auto step = part.ends[1] - part.ends[0];
  if (glm::length(glm::cross(unit, step)) > parallel_sine * glm::length(step)) return nothing;
  const auto off = [&](const Vec3d& p) { return glm::length(glm::cross(unit, p - by.ends[0])); };
  if (off(part.ends[0]) > distance || off(part.ends[1]) > distance) return nothing;
  const auto from = glm::dot(unit, part.ends[0] - by.ends[0]);
  const auto to = glm::dot(unit, part.ends[1] - by.ends[0]);
  const auto at = [&](double place) { return std::clamp((place - from) / (to - from), 0.0, 1.0); };
  const auto [low, high] = std::minmax(at(0.0), at(length));
  return {low, high};
}

// Of lines that lie on each other, the first by weight remains.
std::vector<EdgeShadow> without_doubles(std::vector<EdgeShadow> parts, double reach) {
  std::stable_sort(parts.begin(), parts.end(),
                   [](const EdgeShadow& a, const EdgeShadow& b) { return a.weight > b.weight; });
  std::vector<EdgeShadow> result;
  for (const auto& part : parts) {
    std::vector<EdgeShadow> left{part};
    for (std::size_t i = 0; i < result.size() && !left.empty(); ++i) {
      std::vector<EdgeShadow> next;
      for (const auto& l : left) {
        const auto hidden = covered(l, result[i], beside * reach);
        if (!(hidden.begin < hidden.end)) {
          next.push_back(l);
          continue;
        }
        const auto length = glm::distance(l.ends[0], l.ends[1]);
        if (hidden.begin * length > shortest_left * reach) next.push_back(part_of(l, {0.0, hidden.begin}));
        if ((1.0 - hidden.end) * length > shortest_left * reach)
          next.push_back(part_of(l, {hidden.end, 1.0}));
      }
      left = std::move(next);
    }
    result.insert(result.end(), left.begin(), left.end());
  }
  return result;
}

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
      if ((interval.end - interval.begin) * length > shortest_left * lengths.reach)
        parts.push_back(part_of(shadows[i], interval));
  }
  return without_doubles(std::move(parts), lengths.reach);
}

}  // namespace luxel
