// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/contact_lines.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/hint.h"
#include "luxel/core/none.h"
#include "luxel/core/triangle.h"
#include "luxel/patch/flat_triangle.h"
#include "luxel/patch/line_search.h"
#include "luxel/patch/vertex_triangles.h"

namespace luxel {
namespace {

constexpr double gap_of_edge = 0.01;    // of the shortest edge, at most
constexpr double shortest_part = 32.0;  // in gaps; minimum length of an edge's part within the gap
constexpr double flat_sine = 1e-3;      // below this sine a triangle lies on the other one
constexpr double goes_on_cosine =
    -0.1;  // cosine between the directions from an edge into two triangles of one surface
constexpr double folded_cosine = 0.999;  // the same, of two triangles that lie on each other
constexpr std::size_t shapes_grain = 8192;

using Triangle = std::array<Vec3, 3>;

class Finder {
 public:
  Finder(const std::vector<CleanTriangle>& triangles, const std::vector<Vec3>& positions, double gap,
         std::size_t most, const Context& context)
      : triangles_(triangles),
        positions_(positions),
        max_lines_(most),
        context_(context),
        neighbours_(triangles, positions.size()),
        shapes_(triangles.size()) {
    context.for_chunks(triangles.size(), shapes_grain, [&](std::size_t begin, std::size_t end, int) {
      for (auto i = begin; i < end; ++i) {
        const auto p = points(static_cast<std::uint32_t>(i));
        shapes_[i] = {glm::normalize(area_vector2(p[0], p[1], p[2])),
                      slack_roundings * coordinate_rounding(p),
                      std::min(gap, gap_of_edge * shortest_edge(p))};
      }
    });
  }

  std::vector<ContactLine> find() const {
    return lines_of_pairs(
        boxes(), max_lines_, context_,
        [this](std::uint32_t i, std::uint32_t j, std::vector<ContactLine>& lines) { meet(i, j, lines); });
  }

 private:
  struct Shape {
    Vec3d normal;         // unit
    double slack, reach;  // m: bound of rounding; maximum distance of a triangle that touches it
  };

  // Heights of one triangle's corners above the plane of another.
  struct Heights {
    std::array<double, 3> of{};
    bool all_above(double h) const { return of[0] > h && of[1] > h && of[2] > h; }
    bool all_below(double h) const { return of[0] < h && of[1] < h && of[2] < h; }
  };

  Triangle points(std::uint32_t i) const {
    const auto& c = triangles_[i].corners;
    return {positions_[c[0]], positions_[c[1]], positions_[c[2]]};
  }

  std::vector<Bounds> boxes() const {
    std::vector<Bounds> result(triangles_.size());
    context_.for_chunks(triangles_.size(), shapes_grain, [&](std::size_t begin, std::size_t end, int) {
      for (auto i = begin; i < end; ++i) {
        // The maximum distance of two triangles in contact, plus the rounding of the sum.
        const auto reach = static_cast<float>(1.5 * shapes_[i].slack + shapes_[i].reach);
        for (const auto& corner : points(static_cast<std::uint32_t>(i))) {
          result[i].add(corner - reach);
          result[i].add(corner + reach);
        }
      }
    });
    return result;
  }

  static double shortest_edge(const Triangle& p) {
    return std::min({glm::distance(Vec3d(p[0]), Vec3d(p[1])), glm::distance(Vec3d(p[1]), Vec3d(p[2])),
                     glm::distance(Vec3d(p[2]), Vec3d(p[0]))});
  }

  // A common corner is set exactly into the plane, as rounding would move it.
  Heights heights(std::uint32_t on, std::uint32_t other) const {
    const auto& c = triangles_[on].corners;
    const Vec3d origin(positions_[c[0]]);
    Heights result;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto v = triangles_[other].corners[k];
      if (v != c[0] && v != c[1] && v != c[2])
        result.of[k] = glm::dot(shapes_[on].normal, Vec3d(positions_[v]) - origin);
    }
    return result;
  }

  void meet(std::uint32_t i, std::uint32_t j, std::vector<ContactLine>& lines) const {
    if (are_neighbours(i, j)) return;
    const auto& a = shapes_[i];
    const auto& b = shapes_[j];
    const auto slack = std::max(a.slack, b.slack);
    const auto reach = std::max(slack, std::min(a.reach, b.reach));
    const auto of_j = heights(i, j);
    if (of_j.all_above(reach) || of_j.all_below(-reach)) return;
    const auto of_i = heights(j, i);
    if (of_i.all_above(reach) || of_i.all_below(-reach)) return;
    if (are_beside(i, j, slack, reach) || are_beside(j, i, slack, reach)) return;
    EdgeIntersection(*this, i, j, of_j, {slack, reach}, lines).find();
    EdgeIntersection(*this, j, i, of_i, {slack, reach}, lines).find();
  }

  // Returns whether they share an edge without lying on each other; then they have only that edge in common.
  bool are_neighbours(std::uint32_t i, std::uint32_t j) const {
    const auto& a = triangles_[i].corners;
    const auto& b = triangles_[j].corners;
    const auto apex_of = [](const std::array<std::uint32_t, 3>& c, const std::array<std::uint32_t, 3>& d) {
      std::size_t apex = 3;  // the only corner of c that d does not have
      for (std::size_t k = 0; k < 3; ++k)
        if (c[k] != d[0] && c[k] != d[1] && c[k] != d[2]) apex = apex == 3 ? k : 4;
      return apex;
    };
    const auto k = apex_of(a, b);
    if (k >= 3) return false;
    const auto l = apex_of(b, a);
    // Cosine between the directions from the edge into both triangles, at right angles to it: that of the
    // normals, or its negative.
    const auto cosine = glm::dot(shapes_[i].normal, shapes_[j].normal);
    return (a[(k + 1) % 3] == b[(l + 1) % 3] ? cosine : -cosine) < folded_cosine;
  }

  // Returns whether a plane through an edge of `on` separates it from `other`: at most one corner of `other`
  // is within reach of the plane, or the part within reach lies beside the edge.
  bool are_beside(std::uint32_t on, std::uint32_t other, double slack, double reach) const {
    const auto p = points(on);
    const auto q = points(other);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto edge = Vec3d(p[(k + 1) % 3]) - Vec3d(p[k]);
      const auto inward = glm::cross(shapes_[on].normal, edge);  // as long as the edge
      const auto length2 = glm::dot(edge, edge);
      std::array<double, 3> inside{}, along{};  // m, times the edge's length
      int near = 0;
      bool is_within = false;
      for (std::size_t c = 0; c < 3; ++c) {
        const auto d = Vec3d(q[c]) - Vec3d(p[k]);
        inside[c] = glm::dot(inward, d);
        along[c] = glm::dot(edge, d);
        const bool is_near = inside[c] * inside[c] <= reach * reach * length2;
        near += is_near ? 1 : 0;
        is_within |= !is_near && inside[c] > 0.0;
      }
      if (is_within) continue;
      if (near <= 1) return true;
      if (near == 2 && is_off_the_ends(inside, along, slack, reach, length2)) return true;
    }
    return false;
  }

  // For a triangle with two corners within reach of an edge's line and one outside: returns whether it is
  // within reach only before one end of the edge or beyond the other.
  static bool is_off_the_ends(const std::array<double, 3>& inside, const std::array<double, 3>& along,
                              double slack, double reach, double length2) {
    const auto length = std::sqrt(length2);
    const auto far =
        static_cast<std::size_t>(std::min_element(inside.begin(), inside.end()) - inside.begin());
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const auto c : {(far + 1) % 3, (far + 2) % 3}) {
      const auto fraction =
          (inside[c] + reach * length) / (inside[c] - inside[far]);  // until it leaves the reach
      const auto leaves = along[c] + fraction * (along[far] - along[c]);
      low = std::min({low, along[c], leaves});
      high = std::max({high, along[c], leaves});
    }
    return low >= length2 - slack * length || high <= slack * length;
  }

  // m: bound of rounding; maximum distance of a contact.
  struct Tolerances {
    double slack, reach;
  };

  // The contact of one triangle, `other`, with another one, `on`.
  class EdgeIntersection {
   public:
    EdgeIntersection(const Finder& finder, std::uint32_t on, std::uint32_t other, const Heights& heights,
                     const Tolerances& tolerances, std::vector<ContactLine>& lines)
        : finder_(finder),
          on_(on),
          other_(other),
          height_(heights.of),
          slack_(tolerances.slack),
          reach_(tolerances.reach),
          plane_(finder.points(on), finder.shapes_[on].normal),
          vertex_(finder.triangles_[other].corners),
          lines_(lines) {
      for (std::size_t k = 0; k < 3; ++k) place_[k] = Vec3d(finder.positions_[vertex_[k]]);
    }

    void find() {
      for (std::size_t k = 0; k < 3; ++k) find_touching_edge(k);
      const bool lies_on_it =
          std::all_of(height_.begin(), height_.end(), [this](double h) { return std::fabs(h) <= reach_; });
      if (!lies_on_it) find_passage();
    }

   private:
    struct Touch {
      Vec3d p, q;
    };

    void find_touching_edge(std::size_t k) {
      const auto l = (k + 1) % 3;
      if (std::min(height_[k], height_[l]) > reach_ || std::max(height_[k], height_[l]) < -reach_) return;
      const auto p = plane_.foot_point(place_[k]);
      const auto q = plane_.foot_point(place_[l]);
      auto interval = interval_on(plane_, p, q, slack_);
      if (!interval || !dip(k, l, *interval)) return;
      ContactLine line;
      line.on = on_;
      line.other = other_;
      line.ends = {p + interval->begin * (q - p), p + interval->end * (q - p)};
      if (glm::distance(line.ends[0], line.ends[1]) <= slack_) return;
      touches_.push_back({line.ends[0], line.ends[1]});
      if (interval->begin == 0.0 && std::fabs(height_[k]) <= slack_) line.vertices[0] = vertex_[k];
      if (interval->end == 1.0 && std::fabs(height_[l]) <= slack_) line.vertices[1] = vertex_[l];
      const auto inward = away_from_edge(finder_.positions_, vertex_[k], vertex_[l], vertex_[(k + 2) % 3]);
      const auto sine = glm::dot(inward, plane_.normal);
      if (std::fabs(sine) > flat_sine && std::fabs(height_[(k + 2) % 3]) > reach_) {
        line.into[0] = inward;
      } else {
        if (!is_boundary(k, inward)) return;
        const auto middle = 0.5 * (interval->begin + interval->end);
        const auto lift = height_[k] + middle * (height_[l] - height_[k]);
        line.into[0] = lift < -slack_ ? -plane_.normal : plane_.normal;
        if (std::fabs(lift) <= slack_) line.into[1] = -plane_.normal;
      }
      add(line);
    }

    // Clips the interval to the part within reach of the plane. An edge that crosses the plane steeply does
    // not lie on it; one that leaves it slowly may lie on it in part.
    bool dip(std::size_t k, std::size_t l, Interval& interval) const {
      const auto slope = height_[l] - height_[k];
      const auto at = [&](double t) { return height_[k] + t * slope; };
      if (std::fabs(at(interval.begin)) <= reach_ && std::fabs(at(interval.end)) <= reach_) return true;
      const auto t = std::minmax({(-reach_ - height_[k]) / slope, (reach_ - height_[k]) / slope});
      interval.begin = std::max(interval.begin, t.first);
      interval.end = std::min(interval.end, t.second);
      return (interval.end - interval.begin) * glm::distance(place_[k], place_[l]) >= shortest_part * reach_;
    }

    // Returns whether the surface of `other` ends at its edge k, or folds back there.
    bool is_boundary(std::size_t k, const Vec3d& inward) const {
      const auto a = vertex_[k];
      const auto b = vertex_[(k + 1) % 3];
      return !finder_.neighbours_.any_across(a, b, other_, [&](std::uint32_t apex) {
        return glm::dot(inward, away_from_edge(finder_.positions_, a, b, apex)) < folded_cosine;
      });
    }

    void find_passage() {
      std::array<Vec3d, 2> ends{};
      std::array<std::uint32_t, 2> vertices{none, none};
      std::size_t count = 0;
      for (std::size_t k = 0; k < 3 && count < 2; ++k) {
        const auto l = (k + 1) % 3;
        if (height_[k] == 0.0) {
          vertices[count] = vertex_[k];
          ends[count++] = place_[k];
        } else if (height_[l] != 0.0 && (height_[k] < 0.0) != (height_[l] < 0.0)) {
          // From the lower vertex, so that both triangles at an edge compute the same point.
          const auto [i, j] = vertex_[k] < vertex_[l] ? std::pair(k, l) : std::pair(l, k);
          const auto t = height_[i] / (height_[i] - height_[j]);
          ends[count] = place_[i] + t * (place_[j] - place_[i]);
          for (const auto v : {i, j})
            if (std::fabs(height_[v]) <= slack_ && glm::distance(ends[count], place_[v]) <= slack_)
              vertices[count] = vertex_[v];
          ++count;
        }
      }
      const auto above = *std::max_element(height_.begin(), height_.end());
      const auto below = *std::min_element(height_.begin(), height_.end());
      if (count < 2 || !(above > 0.0 && below < 0.0)) return;
      const auto interval = interval_on(plane_, ends[0], ends[1], slack_);
      if (!interval) return;
      ContactLine line;
      line.on = on_;
      line.other = other_;
      const auto step = ends[1] - ends[0];
      line.ends = {plane_.foot_point(ends[0] + interval->begin * step),
                   plane_.foot_point(ends[0] + interval->end * step)};
      if (interval->begin == 0.0) line.vertices[0] = vertices[0];
      if (interval->end == 1.0) line.vertices[1] = vertices[1];
      if (glm::distance(line.ends[0], line.ends[1]) <= slack_ || is_a_touch(line)) return;
      // A surface that continues by no more than the gap ends here.
      auto into = glm::normalize(glm::cross(finder_.shapes_[other_].normal, step));
      if (glm::dot(into, plane_.normal) < 0.0) into = -into;
      line.into[0] = above > reach_ ? into : -into;
      if (std::min(above, -below) > reach_) line.into[1] = -into;
      add(line);
    }

    // An edge that dips slightly through the plane is where `other` ends, and is already found as a touch.
    bool is_a_touch(const ContactLine& line) const {
      const auto is_near = [&](const Vec3d& p, const Touch& t) {
        const auto along = t.q - t.p;
        const auto fraction = std::clamp(glm::dot(p - t.p, along) / glm::dot(along, along), 0.0, 1.0);
        return glm::distance(p, t.p + fraction * along) <= 2.0 * reach_;
      };
      return std::any_of(touches_.begin(), touches_.end(), [&](const Touch& t) {
        return is_near(line.ends[0], t) && is_near(line.ends[1], t);
      });
    }

    // Skips a line on an edge, or within touching distance of one, where it does not separate light.
    void add(const ContactLine& line) {
      const auto on_edge = interval_on_edge(plane_, line.ends[0], line.ends[1], slack_);
      if (on_edge && (on_edge->length <= slack_ || !parts(on_edge->edge))) return;
      const auto near_edge = interval_on_edge(plane_, line.ends[0], line.ends[1], reach_);
      if (near_edge && near_edge->length > shortest_part * reach_ && !parts(near_edge->edge)) return;
      lines_.push_back(line);
    }

    // Returns whether a surface that stands on edge k separates the light on both sides of it: not where it
    // is a neighbour that also has the edge, and not where the surface `on` itself ends or bends.
    bool parts(std::size_t k) const {
      const auto a = finder_.triangles_[on_].corners[k];
      const auto b = finder_.triangles_[on_].corners[(k + 1) % 3];
      const auto has = [&](std::uint32_t v) { return std::count(vertex_.begin(), vertex_.end(), v) > 0; };
      if (has(a) && has(b)) return false;
      return finder_.neighbours_.any_across(a, b, on_, [&](std::uint32_t apex) {
        return glm::dot(plane_.inward[k], away_from_edge(finder_.positions_, a, b, apex)) < goes_on_cosine;
      });
    }

    const Finder& finder_;
    std::uint32_t on_, other_;
    std::array<double, 3> height_;  // of the corners of `other`
    double slack_, reach_;          // m: bound of rounding; touching distance
    FlatTriangle plane_;
    std::array<std::uint32_t, 3> vertex_;  // of `other`
    std::array<Vec3d, 3> place_{};
    std::vector<Touch> touches_;
    std::vector<ContactLine>& lines_;  // found so far
  };

  const std::vector<CleanTriangle>& triangles_;
  const std::vector<Vec3>& positions_;
  std::size_t max_lines_;
  const Context& context_;
  VertexTriangles neighbours_;
  std::vector<Shape> shapes_;
};

}  // namespace

std::vector<ContactLine> find_contact_lines(const std::vector<CleanTriangle>& triangles,
                                            const std::vector<Vec3>& positions, double gap, std::size_t most,
                                            const Context& context) {
  assert(gap >= 0.0);
  return Finder(triangles, positions, gap, most, context).find();
}

void refuse_contacts(std::size_t most) {
  throw with_hints(InputError(fmt::format(
                       "surfaces touch or pierce one another in so many places that cuts along these make "
                       "more than {} lines or patches: expected fewer, a larger limit, or no such cuts",
                       most)),
                   {{Setting::max_contacts}, {Setting::contacts, "off"}});
}

}  // namespace luxel
