// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/cut_contacts.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <vector>

#include "luxel/core/none.h"
#include "luxel/core/triangle.h"
#include "luxel/patch/edge_points.h"
#include "luxel/patch/flat_triangle.h"
#include "luxel/patch/triangle_cut.h"

namespace luxel {
namespace {

constexpr float same_way = 0.999f;  // minimum cosine between directions into the same surface

// Position of a line's end on a patch: at a corner, on an edge, or inside.
struct LineEnd {
  enum class At { corner, edge, inside } at = At::inside;
  std::size_t k = 0;            // corner or edge
  std::uint32_t request = 0;    // of a point on an edge
  std::uint32_t vertex = none;  // vertex at the end, if there is one
  Vec3d place{0.0};             // m
};

// A line that runs through the inside of a patch.
struct InnerLine {
  std::uint32_t patch;
  std::uint32_t line;
  LineEnd from, to;
};

// A line along an edge, from one fraction of its length to another. A fraction other than 0 or 1 is a
// request.
struct EdgeLine {
  std::array<std::uint32_t, 2> edge;  // the lower vertex first
  std::uint32_t line;
  std::array<std::optional<std::uint32_t>, 2> requests;  // none: the fraction below is an end of the edge
  std::array<double, 2> fractions;
};

class Cutter {
 public:
  Cutter(PatchSet& patches, VertexWeld& weld, std::span<const ContactLine> lines, std::size_t max_added)
      : patches_(patches), weld_(weld), lines_(lines), max_added_(max_added) {}

  // Returns the number of patches that stay whole inside.
  std::size_t cut(std::span<const LineOnPatch> on) {
    for (const auto& o : on) place(o);
    edge_points_.settle(weld_);
    for (const auto& line : edge_lines_) mark(line);
    cut_patches();
    finish_contacts();
    return whole_;
  }

 private:
  std::array<Vec3, 3> points(std::size_t patch) const {
    const auto& c = patches_.corners[patch];
    const auto& p = weld_.positions();
    return {p[c[0]], p[c[1]], p[c[2]]};
  }
  FlatTriangle plane(std::size_t patch) const { return {points(patch), Vec3d(patches_.normal[patch])}; }
  double slack(std::size_t patch) const { return slack_roundings * coordinate_rounding(points(patch)); }

  // Finds the part of a line that lies on a patch, and requests the points that it needs on the patch's
  // edges.
  void place(const LineOnPatch& o) {
    const auto& line = lines_[o.line];
    const auto flat = plane(o.patch);
    const auto near = slack(o.patch);
    const auto p = flat.foot_point(line.ends[0]);
    const auto q = flat.foot_point(line.ends[1]);
    const auto interval = interval_on(flat, p, q, near);
    if (!interval) return;
    const auto from = p + interval->begin * (q - p);
    const auto to = p + interval->end * (q - p);
    if (const auto found = interval_on_edge(flat, from, to, 1.001 * near)) {
      if (found->length > near) place_on_edge(o, *found);
      return;
    }
    InnerLine inner{o.patch, o.line, {}, {}};
    inner.from = locate(o.patch, flat, near, from, interval->begin == 0.0 ? line.vertices[0] : none);
    inner.to = locate(o.patch, flat, near, to, interval->end == 1.0 ? line.vertices[1] : none);
    inner_lines_.push_back(inner);
  }

  LineEnd locate(std::size_t patch, const FlatTriangle& flat, double near, const Vec3d& place,
                 std::uint32_t vertex) {
    LineEnd end;
    end.place = place;
    end.vertex = vertex;
    const auto& corners = patches_.corners[patch];
    for (std::size_t k = 0; k < 3; ++k)
      if (corners[k] == vertex || glm::distance(place, flat.corner[k]) <= near) {
        end.at = LineEnd::At::corner;
        end.k = k;
        return end;
      }
    std::size_t nearest = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (std::fabs(flat.inside(k, place)) < std::fabs(flat.inside(nearest, place))) nearest = k;
    if (std::fabs(flat.inside(nearest, place)) > near) return end;
    end.at = LineEnd::At::edge;
    end.k = nearest;
    end.request = edge_points_.ask(corners[nearest], corners[(nearest + 1) % 3],
                                   std::clamp(flat.along(nearest, place), 0.0, 1.0), vertex);
    return end;
  }

  void place_on_edge(const LineOnPatch& o, const EdgeInterval& found) {
    const auto& corners = patches_.corners[o.patch];
    const auto a = corners[found.edge];
    const auto b = corners[(found.edge + 1) % 3];
    EdgeLine line{{std::min(a, b), std::max(a, b)}, o.line, {}, {}};
    const std::array fractions{found.interval.begin, found.interval.end};
    for (std::size_t i = 0; i < 2; ++i) {
      line.fractions[i] = a < b ? fractions[i] : 1.0 - fractions[i];
      if (fractions[i] > 0.0 && fractions[i] < 1.0)
        line.requests[i] = edge_points_.ask(a, b, fractions[i], none);
    }
    edge_lines_.push_back(line);
  }

  // Records the contact on each part of the edge between the line's ends.
  void mark(const EdgeLine& line) {
    auto fractions = line.fractions;
    for (std::size_t i = 0; i < 2; ++i)
      if (line.requests[i]) fractions[i] = edge_points_.answer(*line.requests[i]).fraction;
    const auto begin = std::min(fractions[0], fractions[1]);
    const auto end = std::max(fractions[0], fractions[1]);
    EdgePoints::Station last{0.0, line.edge[0]};
    const auto step_to = [&](const EdgePoints::Station& next) {
      if (last.fraction >= begin && next.fraction <= end) note(last.vertex, next.vertex, line.line);
      last = next;
    };
    for (const auto& station : edge_points_.on(line.edge[0], line.edge[1])) step_to(station);
    step_to({1.0, line.edge[1]});
  }

  void note(std::uint32_t a, std::uint32_t b, std::uint32_t line) {
    const auto [low, high] = std::minmax(a, b);
    const auto& p = weld_.positions();
    const auto along = glm::normalize(Vec3d(p[high]) - Vec3d(p[low]));
    for (const auto& into : lines_[line].into) {
      const auto across = into - glm::dot(into, along) * along;
      const auto length = glm::length(across);
      if (length > 0.5) patches_.contacts.push_back({{low, high}, Vec3(across / length)});
    }
  }

  void cut_patches() {
    PatchSet cut;
    auto inner = inner_lines_.begin();
    for (std::uint32_t p = 0; p < patches_.size(); ++p) {
      const auto first = inner;
      while (inner != inner_lines_.end() && inner->patch == p) ++inner;
      const auto& c = patches_.corners[p];
      if (first != inner || !on_edge(c, 0).empty() || !on_edge(c, 1).empty() || !on_edge(c, 2).empty())
        cut_patch(p, {first, inner}, cut);
      else
        append(p, c, patches_.area[p], cut);
    }
    patches_.corners = std::move(cut.corners);
    patches_.normal = std::move(cut.normal);
    patches_.area = std::move(cut.area);
    patches_.material = std::move(cut.material);
    patches_.triangle = std::move(cut.triangle);
  }

  std::span<const EdgePoints::Station> on_edge(const std::array<std::uint32_t, 3>& c, std::size_t k) const {
    return edge_points_.on(c[k], c[(k + 1) % 3]);
  }

  void append(std::size_t from, const std::array<std::uint32_t, 3>& corners, float area, PatchSet& to) const {
    to.corners.push_back(corners);
    to.normal.push_back(patches_.normal[from]);
    to.area.push_back(area);
    to.material.push_back(patches_.material[from]);
    to.triangle.push_back(patches_.triangle[from]);
  }

  void cut_patch(std::uint32_t patch, std::span<const InnerLine> inner, PatchSet& cut) {
    const auto& c = patches_.corners[patch];
    TriangleCut fragments(plane(patch), slack(patch));
    std::vector<std::uint32_t> vertex(c.begin(), c.end());  // of each point
    for (std::size_t k = 0; k < 3; ++k) {
      const auto stations = on_edge(c, k);
      const bool is_forwards = c[k] < c[(k + 1) % 3];
      for (std::size_t i = 0; i < stations.size(); ++i) {
        const auto& s = is_forwards ? stations[i] : stations[stations.size() - 1 - i];
        const auto point = fragments.add_on_edge(k, is_forwards ? s.fraction : 1.0 - s.fraction);
        if (point == vertex.size()) vertex.push_back(s.vertex);
      }
    }
    // All points precede the lines, so that a line bends to them.
    std::vector<std::array<std::uint32_t, 2>> ends;
    for (const auto& line : inner)
      ends.push_back({point_of(line.from, fragments, vertex), point_of(line.to, fragments, vertex)});
    for (std::size_t i = 0; i < inner.size(); ++i) {
      fragments.add_line(ends[i][0], ends[i][1], inner[i].line);
      if (added_ + fragments.fragments().size() > max_added_) {
        ++whole_;
        return cut_patch(patch, {}, cut);
      }
    }
    added_ += fragments.fragments().size() - 1;
    fragments.improve();
    for (auto p = vertex.size(); p < fragments.points(); ++p)
      vertex.push_back(weld_.index_of(Vec3(fragments.place(static_cast<std::uint32_t>(p)))));

    for (const auto& [edge, tags] : fragments.lines())
      for (const auto line : tags)
        if (vertex[edge.first] != vertex[edge.second]) note(vertex[edge.first], vertex[edge.second], line);
    for (const auto& fragment : fragments.fragments()) {
      const std::array corners{vertex[fragment.v[0]], vertex[fragment.v[1]], vertex[fragment.v[2]]};
      const auto& p = weld_.positions();
      const auto area = static_cast<float>(triangle_area(p[corners[0]], p[corners[1]], p[corners[2]]));
      if (area > 0.0f) append(patch, corners, area, cut);
    }
  }

  std::uint32_t point_of(const LineEnd& end, TriangleCut& fragments, std::vector<std::uint32_t>& vertex) {
    if (end.at == LineEnd::At::corner) return static_cast<std::uint32_t>(end.k);
    if (end.at == LineEnd::At::edge) {
      const auto wanted = edge_points_.answer(end.request).vertex;
      const auto found = std::find(vertex.begin(), vertex.end(), wanted);
      return found == vertex.end() ? static_cast<std::uint32_t>(end.k)
                                   : static_cast<std::uint32_t>(found - vertex.begin());
    }
    const auto point = fragments.add_inside(end.place);
    if (point == vertex.size())
      vertex.push_back(end.vertex != none ? end.vertex : weld_.index_of(Vec3(end.place)));
    return point;
  }

  // Sorts the contacts. Of several on one edge with the same direction the first remains: the others come
  // from the second half of a wall, or from the other side of the edge.
  void finish_contacts() {
    auto& all = patches_.contacts;
    const auto order = [](const Contact& c) { return std::tuple(c.edge, c.into.x, c.into.y, c.into.z); };
    std::sort(all.begin(), all.end(),
              [&](const Contact& a, const Contact& b) { return order(a) < order(b); });
    std::vector<Contact> kept;
    for (const auto& c : all) {
      auto same = kept.rbegin();
      while (same != kept.rend() && same->edge == c.edge && glm::dot(same->into, c.into) < same_way) ++same;
      if (same == kept.rend() || same->edge != c.edge) kept.push_back(c);
    }
    all = std::move(kept);
  }

  PatchSet& patches_;
  VertexWeld& weld_;
  std::span<const ContactLine> lines_;
  std::size_t max_added_, added_ = 0, whole_ = 0;  // patches
  EdgePoints edge_points_;
  std::vector<InnerLine> inner_lines_;
  std::vector<EdgeLine> edge_lines_;
};

}  // namespace

std::size_t cut_along_contacts(PatchSet& patches, VertexWeld& weld, std::span<const ContactLine> lines,
                               std::span<const LineOnPatch> on, std::size_t max_added) {
  return Cutter(patches, weld, lines, max_added).cut(on);
}

}  // namespace luxel
