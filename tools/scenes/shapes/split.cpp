// SPDX-License-Identifier: Apache-2.0
#include "scenes/shapes/split.h"

#include <algorithm>
#include <map>
#include <utility>

namespace luxel::scenes {
namespace {

class Splitter {
 public:
  Splitter(const Mesh& mesh, int pieces) : mesh_(mesh), pieces_(pieces) { result_.points = mesh.points; }

  void add(const Triangle& triangle) {
    // Rows from corner a to the edge bc; row i has i + 1 points.
    const auto& [a, b, c] = triangle.corners;
    auto last = std::vector<std::uint32_t>{a};
    for (auto i = 1; i <= pieces_; ++i) {
      auto row = std::vector<std::uint32_t>{};
      for (auto j = 0; j <= i; ++j) row.push_back(point(triangle, i - j, j));
      for (auto j = 0u; j < last.size(); ++j) {
        add_small(last[j], row[j], row[j + 1], triangle.paint);
        if (j + 1 < last.size()) add_small(last[j], row[j + 1], last[j + 1], triangle.paint);
      }
      last = std::move(row);
    }
  }

  Mesh take() { return std::move(result_); }

 private:
  void add_small(std::uint32_t a, std::uint32_t b, std::uint32_t c, Paint paint) {
    result_.triangles.push_back({{a, b, c}, paint});
  }

  // The point j steps of c and i of b away from a.
  std::uint32_t point(const Triangle& triangle, int i, int j) {
    const auto& [a, b, c] = triangle.corners;
    const auto rest = pieces_ - i - j;
    if (i == 0) return on_edge(a, c, j);
    if (j == 0) return on_edge(a, b, i);
    if (rest == 0) return on_edge(b, c, j);
    const auto& p = mesh_.points;
    return result_.add_point((p[a] * double(rest) + p[b] * double(i) + p[c] * double(j)) / double(pieces_));
  }

  std::uint32_t on_edge(std::uint32_t from, std::uint32_t to, int step) {
    if (step == 0) return from;
    if (step == pieces_) return to;
    if (from > to) {
      std::swap(from, to);
      step = pieces_ - step;
    }
    const auto [at, is_new] = first_on_edge_.try_emplace({from, to}, 0u);
    if (is_new) {
      at->second = static_cast<std::uint32_t>(result_.points.size());
      for (auto k = 1; k < pieces_; ++k)
        result_.add_point((mesh_.points[from] * double(pieces_ - k) + mesh_.points[to] * double(k)) /
                          double(pieces_));
    }
    return at->second + static_cast<std::uint32_t>(step - 1);
  }

  const Mesh& mesh_;
  int pieces_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> first_on_edge_;
  Mesh result_;
};

}  // namespace

Mesh split(const Mesh& mesh, int pieces) {
  if (pieces == 1) return mesh;
  auto splitter = Splitter(mesh, pieces);
  for (const auto& triangle : mesh.triangles) splitter.add(triangle);
  return splitter.take();
}

}  // namespace luxel::scenes
