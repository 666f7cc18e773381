// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/shadow_lines.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "luxel/core/trig.h"
#include "luxel/lamps/lamp_bodies.h"
#include "luxel/lamps/outer_back.h"
#include "luxel/lamps/outline_edges.h"
#include "luxel/lamps/shadow_corners.h"
#include "luxel/lamps/shadow_links.h"
#include "luxel/lamps/shadow_parts.h"
#include "luxel/lamps/shadow_receivers.h"
#include "luxel/patch/contact_lines.h"
#include "luxel/patch/vertex_triangles.h"
#include "luxel/scene/clean_triangles.h"
#include "luxel/trace/point_sight.h"

namespace luxel {
namespace {

constexpr double reach_of_edge = 1.25e-4;  // distance of pairs of rays from a line, in `detail`
constexpr double reach_roundings = 256.0;  // the same, at least, in roundings of the coordinates
// Patches that lines add. Measured: 3.0 to 3.3 per line in four scenes, where most lines are shorter than
// max_edge. A long line crosses about 2.5 patches per max_edge, each of which becomes three.
constexpr double patches_per_line = 3.0, patches_per_edge = 5.0;
// Candidates that are looked at, per line that is wanted: most edges have several shadows.
constexpr double edges_per_line = 8.0, shadows_per_line = 24.0;
constexpr std::size_t edges_grain = 64, edges_per_report = 1 << 14;
constexpr double min_lines = 64.0;
constexpr std::size_t max_bodies = 32;        // lamps with surfaces that are looked at
constexpr double nearest_edge = 3.0;          // to a lamp, in its radius: of others shadows are soft
constexpr double beside_a_lamp = 1.0 / 1024;  // of its size: rays to a vertex pass the lamp at this distance

// An outline edge with its light: a punctual one, or after these a lamp's body.
struct LitEdge {
  OutlineEdge edge;
  std::uint32_t light;
};

class Finder {
 public:
  Finder(const PatchSet& triangles, const Tracer& tracer, const ShadowLineOptions& options,
         const Context& context)
      : triangles_(triangles),
        tracer_(tracer),
        options_(options),
        context_(context),
        clean_(clean_triangles_of(triangles)),
        neighbours_(clean_, triangles.vertices.size()),
        bodies_(find_lamp_bodies(triangles, max_bodies)),
        lengths_{detail(options), reach(detail(options)), widest_penumbra(options)} {}

  std::vector<ShadowLine> find() {
    if (triangles_.point_lights.empty() && bodies_.empty()) return {};
    auto edges = outline_edges();
    split_penumbras(edges);
    auto shadows = shadows_of(edges);
    if (!shadows || shadows->empty()) return {};
    sort_by_benefit(*shadows);
    keep_whole_edges(*shadows, max_candidates(shadows_per_line));
    const auto links = std::stable_partition(shadows->begin(), shadows->end(),
                                             [](const EdgeShadow& s) { return !s.is_link; });
    std::stable_sort(shadows->begin(), links,
                     [](const EdgeShadow& a, const EdgeShadow& b) { return a.triangle < b.triangle; });
    auto parts = verified({shadows->begin(), links});
    const auto joining = joining_links({links, shadows->end()}, parts, lengths_.reach);
    parts.insert(parts.end(), joining.begin(), joining.end());
    return lines_of(within_budget(std::move(parts)));
  }

 private:
  // Patches of whole triangles are triangles again.
  static std::vector<CleanTriangle> clean_triangles_of(const PatchSet& triangles) {
    std::vector<CleanTriangle> result(triangles.size());
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] = {triangles.corners[i], triangles.triangle[i], false};
    return result;
  }

  static double detail(const ShadowLineOptions& options) {
    return options.detail > 0.0 ? options.detail : options.max_edge;
  }

  static double widest_penumbra(const ShadowLineOptions& options) {
    return options.widest_penumbra > 0.0 ? options.widest_penumbra : 0.5 * options.max_edge;
  }

  double reach(double detail) const {
    double largest = 0.0;
    for (const auto& p : triangles_.vertices)
      for (int axis = 0; axis < 3; ++axis)
        largest = std::max(largest, std::abs(static_cast<double>(p[axis])));
    return std::max(reach_of_edge * detail, reach_roundings * 0x1p-24 * largest);
  }

  std::size_t max_candidates(double per_line) const {
    const auto lines = static_cast<double>(options_.max_patches) / (patches_per_line + patches_per_edge);
    return static_cast<std::size_t>(per_line * std::max(min_lines, lines));
  }
  std::size_t max_edges() const { return max_candidates(edges_per_line); }

  template <typename Item, typename Weight>
  static void keep_first(std::vector<Item>& items, std::size_t count, const Weight& weight) {
    std::stable_sort(items.begin(), items.end(),
                     [&](const Item& a, const Item& b) { return weight(a) > weight(b); });
    if (items.size() > count) items.resize(count);
  }
  double patches_added(const EdgeShadow& s) const {
    return patches_per_line + patches_per_edge * glm::distance(s.ends[0], s.ends[1]) / options_.max_edge;
  }
  // First the shadows of the edges that have the most light for the patches that they add.
  void sort_by_benefit(std::vector<EdgeShadow>& shadows) const {
    struct Whole {
      double weight = 0.0, patches = 0.0;
    };
    std::vector<Whole> of_edge;
    for (const auto& s : shadows) {
      if (s.edge >= of_edge.size()) of_edge.resize(s.edge + std::size_t{1});
      auto& whole = of_edge[s.edge];
      whole.weight += s.weight;
      whole.patches += patches_added(s);
    }
    const auto key = [&](const EdgeShadow& s) {
      const auto& whole = of_edge[s.edge];
      return std::pair(-whole.weight / whole.patches, s.edge);
    };
    std::stable_sort(shadows.begin(), shadows.end(),
                     [&](const EdgeShadow& a, const EdgeShadow& b) { return key(a) < key(b); });
  }
  // Keeps at most this many of the first, and only all of an edge: a line with gaps shows.
  static void keep_whole_edges(std::vector<EdgeShadow>& shadows, std::size_t count) {
    if (count >= shadows.size()) return;
    while (count > 0 && shadows[count - 1].edge == shadows[count].edge) --count;
    shadows.resize(count);
  }

  std::vector<LitEdge> outline_edges() const {
    std::vector<LitEdge> edges;
    const auto weight = [](const LitEdge& e) { return e.edge.weight; };
    const auto add = [&](const BandPointLight& light, std::size_t number, double radius = 0.0) {
      const Vec3d centre(light.light.position);
      for (const auto& edge : find_outline_edges(triangles_, neighbours_, light, context_))
        if (glm::distance(0.5 * (edge.a + edge.b), centre) >= nearest_edge * radius)
          edges.push_back({edge, static_cast<std::uint32_t>(number)});
      if (edges.size() > 2 * max_edges()) keep_first(edges, max_edges(), weight);
    };
    const auto& lights = triangles_.point_lights;
    for (std::size_t i = 0; i < lights.size(); ++i)
      if (!has_opening(lights[i].light)) add(lights[i], i);  // others have soft shadows
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      add(bodies_[i].centre, lights.size() + i, bodies_[i].radius);
    keep_first(edges, max_edges(), weight);
    return edges;
  }

  bool is_body(const LitEdge& e) const { return e.light >= triangles_.point_lights.size(); }
  std::uint32_t body_of(const LitEdge& e) const {
    return e.light - static_cast<std::uint32_t>(triangles_.point_lights.size());
  }

  // The disc of a sun, and the body of a lamp, give each edge two lines, where the penumbra begins and ends.
  void split_penumbras(std::vector<LitEdge>& edges) {
    const auto is_soft = [&](const LitEdge& e) {
      return is_body(e) || is_extended(triangles_.point_lights[e.light].light);
    };
    if (std::none_of(edges.begin(), edges.end(), is_soft)) return;
    with_rims_ = triangles_;
    std::vector<LitEdge> split;
    for (const auto& e : edges) {
      if (!is_soft(e)) {
        split.push_back(e);
      } else if (is_body(e)) {
        for (const auto& rim : rims_of_body(e)) split.push_back(rim);
      } else {
        for (const double sign : {-1.0, 1.0}) split.push_back({e.edge, rim_of_sun(e, sign)});
      }
    }
    edges = std::move(split);
  }

  std::uint32_t add_rim(BandPointLight rim) {
    with_rims_->point_lights.push_back(std::move(rim));
    return static_cast<std::uint32_t>(with_rims_->point_lights.size() - 1);
  }

  // A sun without a disc, turned about the edge by the angular radius.
  std::uint32_t rim_of_sun(const LitEdge& e, double sign) {
    auto rim = triangles_.point_lights[e.light];
    const auto axis = glm::normalize(e.edge.b - e.edge.a);
    const auto turn = sin_cos(sign * static_cast<double>(rim.light.angular_radius));
    const Vec3d way(rim.light.direction);
    const auto along = glm::dot(axis, way) * axis;
    rim.light.direction = Vec3(along + turn.cosine * (way - along) + turn.sine * glm::cross(axis, way));
    rim.light.angular_radius = 0.0f;
    return add_rim(std::move(rim));
  }

  // Points at the two vertices of a lamp that are the first and the last to be seen past the edge.
  std::array<LitEdge, 2> rims_of_body(const LitEdge& e) {
    const auto& body = bodies_[body_of(e)];
    const auto axis = glm::normalize(e.edge.b - e.edge.a);
    const Vec3d centre(body.centre.light.position);
    const auto middle = 0.5 * (e.edge.a + e.edge.b);
    const auto towards = glm::cross(axis, e.edge.outward);
    const auto sign = glm::dot(towards, centre - middle) > 0.0 ? 1.0 : -1.0;
    const auto angle = [&](const Vec3d& p) {
      return std::atan2(glm::dot(p - middle, e.edge.outward), sign * glm::dot(p - middle, towards));
    };
    std::vector<double> angles;
    for (const auto& p : body.vertices) angles.push_back(angle(p));
    const auto [first, last] = std::minmax_element(angles.begin(), angles.end());
    std::array<LitEdge, 2> result{e, e};
    for (const auto i : {0u, 1u}) {
      const auto number = static_cast<std::size_t>((i == 0 ? first : last) - angles.begin());
      const auto& vertex = body.vertices[number];
      const auto turn = sin_cos(angles[number]);
      auto& edge = result[i].edge;
      edge.outward = turn.cosine * e.edge.outward - turn.sine * sign * towards;
      edge.penumbra = 2 * body_of(e) + i;
      edge.spread = *last - *first;
      const auto [rim, is_new] = rims_.try_emplace({e.light, number}, 0u);
      if (is_new) {
        auto light = body.centre;
        light.light.position = Vec3(vertex + beside_a_lamp * (vertex - centre));
        rim->second = add_rim(std::move(light));
      }
      result[i].light = rim->second;
    }
    return result;
  }

  // The triangles with the lights that edges name.
  const PatchSet& lights() const { return with_rims_ ? *with_rims_ : triangles_; }

  // Returns nothing after the monitor's stop.
  std::optional<std::vector<EdgeShadow>> shadows_of(const std::vector<LitEdge>& edges) const {
    const ShadowReceivers receivers(lights(), neighbours_, tracer_, lengths_);
    std::vector<EdgeShadow> shadows;
    for (std::size_t first = 0; first < edges.size(); first += edges_per_report) {
      const auto count = std::min(edges_per_report, edges.size() - first);
      std::vector<std::vector<EdgeShadow>> of_chunk((count + edges_grain - 1) / edges_grain);
      context_.for_chunks(count, edges_grain, [&](std::size_t begin, std::size_t end, int) {
        auto& some = of_chunk[begin / edges_grain];
        for (auto i = begin; i < end; ++i) {
          const auto known = some.size();
          receivers.add_shadows(edges[first + i].light, edges[first + i].edge, some);
          for (auto& s : std::span(some).subspan(known)) s.edge = static_cast<std::uint32_t>(first + i);
        }
      });
      for (const auto& some : of_chunk) shadows.insert(shadows.end(), some.begin(), some.end());
      if (context_.report({.stage = "patches"}) == Next::stop) return std::nullopt;
    }
    return shadows;
  }

  // shadows: sorted by triangle.
  std::vector<EdgeShadow> verified(std::span<const EdgeShadow> shadows) const {
    const auto contacts = find_contact_lines(clean_, triangles_.vertices, options_.contact_gap,
                                             options_.max_contacts, context_);
    std::vector<std::span<const EdgeShadow>> groups;
    for (auto begin = shadows.begin(); begin != shadows.end();) {
      const auto on = begin->triangle;
      const auto end =
          std::find_if(begin, shadows.end(), [&](const EdgeShadow& s) { return s.triangle != on; });
      groups.emplace_back(begin, end);
      begin = end;
    }
    std::vector<std::vector<EdgeShadow>> parts(groups.size());
    context_.for_chunks(groups.size(), 1, [&](std::size_t g, std::size_t, int) {
      const auto on = groups[g].front().triangle;
      const auto range =
          std::equal_range(contacts.begin(), contacts.end(), ContactLine{.on = on},
                           [](const ContactLine& a, const ContactLine& b) { return a.on < b.on; });
      parts[g] = true_parts(lights(), tracer_, groups[g], {range.first, range.second}, lengths_);
      std::erase_if(parts[g], [&](const EdgeShadow& s) { return is_on_outer_back(lights(), tracer_, s); });
    });
    std::vector<EdgeShadow> result;
    for (const auto& some : parts) result.insert(result.end(), some.begin(), some.end());
    const auto corners = corner_lines(triangles_, result, lengths_);
    result.insert(result.end(), corners.begin(), corners.end());
    return result;
  }

  std::vector<EdgeShadow> within_budget(std::vector<EdgeShadow> shadows) const {
    sort_by_benefit(shadows);
    double added = 0.0;
    std::size_t count = 0;
    for (; count < shadows.size(); ++count) {
      added += patches_added(shadows[count]);
      if (added > static_cast<double>(options_.max_patches)) break;
    }
    keep_whole_edges(shadows, count);
    return shadows;
  }

  std::vector<ShadowLine> lines_of(const std::vector<EdgeShadow>& shadows) const {
    std::vector<ShadowLine> lines;
    for (const auto& s : shadows) lines.push_back({triangles_.triangle[s.triangle], s.ends, s.lit_side});
    const auto key = [](const ShadowLine& l) {
      const auto& [p, q] = l.ends;
      return std::tuple(l.triangle, p.x, p.y, p.z, q.x, q.y, q.z);
    };
    std::stable_sort(lines.begin(), lines.end(),
                     [&](const ShadowLine& a, const ShadowLine& b) { return key(a) < key(b); });
    return lines;
  }

  const PatchSet& triangles_;
  std::optional<PatchSet> with_rims_;  // the same, where lights have penumbras: with their rims as lights
  std::map<std::pair<std::uint32_t, std::size_t>, std::uint32_t> rims_;  // of a lamp's vertices, as lights
  const Tracer& tracer_;
  const ShadowLineOptions& options_;
  const Context& context_;
  std::vector<CleanTriangle> clean_;
  VertexTriangles neighbours_;
  std::vector<LampBody> bodies_;
  ShadowReceivers::Lengths lengths_;
};

}  // namespace

std::vector<ShadowLine> find_shadow_lines(const PatchSet& triangles, const Tracer& tracer,
                                          const ShadowLineOptions& options, const Context& context) {
  assert(options.max_edge > 0.0);
  return Finder(triangles, tracer, options, context).find();
}

}  // namespace luxel
