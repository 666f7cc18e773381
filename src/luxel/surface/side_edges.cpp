// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/side_edges.h"

#include <algorithm>
#include <tuple>

#include "luxel/patch/side.h"
#include "luxel/surface/side_nodes.h"

namespace luxel {
namespace {

// A part of a patch's edge; the lower vertex first.
struct Part {
  std::array<std::uint32_t, 2> ends;
  std::array<float, 2> at;  // of the ends, as fractions of the edge's length
  std::uint32_t patch, edge;
  std::array<std::array<std::uint32_t, 2>, 2> nodes;  // [front, back][end]
  bool upwards;                                       // the winding runs from the lower vertex to the higher

  auto order() const { return std::tuple(ends, patch, edge, at); }
};

// A point on a patch's edge: a corner or a hanging vertex.
struct Stop {
  std::uint32_t vertex;
  float at;
  std::array<std::uint32_t, 2> node;  // of the front, of the back
};

class Parts {
 public:
  Parts(const PatchSet& patches, const SideNodes& nodes) : patches_(patches), nodes_(nodes) {
    order_hanging();
    for (std::uint32_t p = 0; p < patches.size(); ++p)
      for (std::uint32_t k = 0; k < 3; ++k) add(p, k);
    std::sort(parts_.begin(), parts_.end(),
              [](const Part& a, const Part& b) { return a.order() < b.order(); });
  }
  const std::vector<Part>& all() const { return parts_; }

 private:
  void order_hanging() {
    const auto& hanging = nodes_.hanging;
    for (std::uint32_t h = 0; h < hanging.size(); ++h) order_.push_back(h);
    std::sort(order_.begin(), order_.end(), [&](auto a, auto b) {
      const auto &x = hanging[a], &y = hanging[b];
      return std::tuple(x.patch, x.edge, x.fraction, a) < std::tuple(y.patch, y.edge, y.fraction, b);
    });
    hanging_nodes_.resize(hanging.size());
    for (const auto& visit : nodes_.visits)
      for (const auto& m : nodes_.at(visit.node))
        if (m.side == visit.side && m.place >= 3)
          hanging_nodes_[m.place - 3][m.side.is_back() ? 1 : 0] = visit.node;
  }

  Stop corner(std::uint32_t p, std::uint32_t k, float at) const {
    return {patches_.corners[p][k],
            at,
            {nodes_.of_side[SideId(p, false).index()][k], nodes_.of_side[SideId(p, true).index()][k]}};
  }

  void add(std::uint32_t p, std::uint32_t k) {
    auto from = corner(p, k, 0.0f);
    for (; next_ < order_.size(); ++next_) {
      const auto& h = nodes_.hanging[order_[next_]];
      if (h.patch != p || h.edge != k) break;
      const Stop to{h.vertex, h.fraction, hanging_nodes_[order_[next_]]};
      add(p, k, from, to);
      from = to;
    }
    add(p, k, from, corner(p, (k + 1) % 3, 1.0f));
  }

  void add(std::uint32_t p, std::uint32_t k, const Stop& from, const Stop& to) {
    if (from.vertex == to.vertex) return;
    const bool upwards = from.vertex < to.vertex;
    const auto &a = upwards ? from : to, &b = upwards ? to : from;
    parts_.push_back({{a.vertex, b.vertex},
                      {a.at, b.at},
                      p,
                      k,
                      {{{a.node[0], b.node[0]}, {a.node[1], b.node[1]}}},
                      upwards});
  }

  const PatchSet& patches_;
  const SideNodes& nodes_;
  std::vector<std::uint32_t> order_;  // of SideNodes::hanging, by patch, edge and place
  std::vector<std::array<std::uint32_t, 2>> hanging_nodes_;  // [hanging][front, back]
  std::size_t next_ = 0;                                     // in order_
  std::vector<Part> parts_;
};

// Returns whether a contact lies on the edge in front of these two sides.
bool is_touched(const PatchSet& patches, const SideEdge& e) {
  const auto before = [](const Contact& c, const auto& ends) { return c.edge < ends; };
  const auto looks = patches.normal_of(e.halves[0].side) + patches.normal_of(e.halves[1].side);
  for (auto c = std::lower_bound(patches.contacts.begin(), patches.contacts.end(), e.ends, before);
       c != patches.contacts.end() && c->edge == e.ends; ++c)
    if (glm::dot(c->into, looks) > 0.0f) return true;
  return false;
}

}  // namespace

std::vector<SideEdge> find_side_edges(const PatchSet& patches, const SideNodes& nodes) {
  const Parts parts(patches, nodes);
  std::vector<SideEdge> edges;
  const auto meet = [&](const Part& a, const Part& b) {
    for (std::uint32_t back = 0; back < 2; ++back) {
      // Windings that run the same way along an edge face opposite directions.
      const auto other = a.upwards == b.upwards ? 1 - back : back;
      SideEdge e;
      e.halves = {SideEdge::Half{{a.patch, back == 1}, a.edge, a.at[0], a.at[1]},
                  SideEdge::Half{{b.patch, other == 1}, b.edge, b.at[0], b.at[1]}};
      e.ends = a.ends;
      e.smooth = a.nodes[back] == b.nodes[other] && !is_touched(patches, e);
      edges.push_back(e);
    }
  };
  const auto& all = parts.all();
  for (std::size_t i = 0; i < all.size(); ++i)
    for (auto j = i + 1; j < all.size() && all[j].ends == all[i].ends; ++j) meet(all[i], all[j]);
  return edges;
}

}  // namespace luxel
