// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "luxel/core/vector.h"
#include "luxel/scene/vertex_weld.h"

namespace luxel {

// Points on edges of a mesh, such that all triangles at an edge get the same ones. Points are first
// requested, from any triangle; settle() then merges those nearer to each other, or to an end of the edge,
// than rounding resolves, and makes vertices of the rest.
class EdgePoints {
 public:
  struct Station {
    double fraction;       // of the edge's length, from its lower vertex
    std::uint32_t vertex;  // in the weld
  };

  // Requests a point at this fraction of the way from vertex a to vertex b. vertex: an existing one there, or
  // none. Returns the number of the request.
  std::uint32_t ask(std::uint32_t a, std::uint32_t b, double fraction, std::uint32_t vertex);
  // Cost: a sort of each edge's requests. Vertices are made in the order in which their edges were first
  // named.
  void settle(VertexWeld& weld);

  // Result of a request after settle(): a station of its edge, or an end, whose fraction is 0 or 1.
  const Station& answer(std::uint32_t request) const { return answers_[request]; }
  // The stations between the two ends of an edge, in the order of their fractions; often none.
  std::span<const Station> on(std::uint32_t a, std::uint32_t b) const;
  bool empty() const { return edges_.empty(); }

 private:
  struct Request {
    double fraction;
    std::uint32_t vertex;
    std::uint32_t number;
  };
  struct Edge {
    std::array<std::uint32_t, 2> ends;  // the lower first
    std::vector<Request> requests;
    std::vector<Station> stations;
  };
  void settle(Edge& edge, VertexWeld& weld);

  std::unordered_map<std::uint64_t, std::uint32_t> number_;  // of an edge
  std::vector<Edge> edges_;
  std::vector<Station> answers_;
  std::vector<bool> is_end_;  // [vertex]: of an edge that has requests
};

}  // namespace luxel
