// SPDX-License-Identifier: Apache-2.0
#include "luxel/classical/hemicube.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/none.h"
#include "luxel/core/triangle.h"
#include "luxel/core/warp.h"
#include "luxel/patch/side.h"
#include "luxel/trace/patch_emitter.h"
#include "luxel/trace/tracer.h"

namespace luxel {
namespace {

// A face looks along an axis (u, v, 1): the positions of these three components in local coordinates.
struct Axes {
  glm::length_t u, v, w;
  double sign;  // of the component w
};
constexpr std::array<Axes, 5> axes = {
    {{0, 1, 2, 1.0}, {1, 2, 0, 1.0}, {1, 2, 0, -1.0}, {0, 2, 1, 1.0}, {0, 2, 1, -1.0}}};

constexpr double fronts_first = 1.0 + 1e-6;

constexpr std::uint32_t below = 1u << 20;  // bit of the horizon

// Four bits per face, one for each plane of its pyramid: set where p is outside. All planes contain the eye,
// so a triangle whose corners share a bit is not visible in that face.
std::uint32_t outside_bits(const Vec3& p) {
  const auto bit = [](bool is_outside, int place) { return static_cast<std::uint32_t>(is_outside) << place; };
  const auto [x, y, z] = std::array{p.x, p.y, p.z};
  return bit(x > z, 0) | bit(-x > z, 1) | bit(y > z, 2) | bit(-y > z, 3) |     // top
         bit(y > x, 4) | bit(-y > x, 5) | bit(z > x, 6) | bit(x <= 0.0f, 7) |  // +x
         bit(y > -x, 8) | bit(-y > -x, 9) | bit(z > -x, 10) | bit(x >= 0.0f, 11) | bit(x > y, 12) |
         bit(-x > y, 13) | bit(z > y, 14) | bit(y <= 0.0f, 15) | bit(x > -y, 16) | bit(-x > -y, 17) |
         bit(z > -y, 18) | bit(y >= 0.0f, 19) | bit(z <= 0.0f, 20);
}

// Centres of 4^depth equal parts of a triangle.
void add_centres(const Vec3d& a, const Vec3d& b, const Vec3d& c, int parts, std::vector<Vec3d>& centres) {
  if (parts <= 1) {
    centres.push_back((a + b + c) / 3.0);
    return;
  }
  const auto ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
  add_centres(a, ab, ca, parts / 4, centres);
  add_centres(ab, b, bc, parts / 4, centres);
  add_centres(ca, bc, c, parts / 4, centres);
  add_centres(bc, ca, ab, parts / 4, centres);
}

void check(const HemicubeOptions& options) {
  const auto n = options.resolution;
  if (n < 2 || n > 4096 || n % 2 != 0)
    throw InputError(fmt::format("a hemicube has an even resolution of 2 to 4096 pixels, not {}", n));
  const auto points = {1, 4, 16, 64, 256};
  if (std::find(points.begin(), points.end(), options.points) == points.end())
    throw InputError(fmt::format("a hemicube looks from 1, 4, 16, 64 or 256 points, not {}", options.points));
}

// The smallest integer that is at least x, for x in [0, 4096].
int at_least(double x) {
  const auto whole = static_cast<int>(x);
  return static_cast<double>(whole) < x ? whole + 1 : whole;
}

}  // namespace

Hemicube::Hemicube(const PatchSet& patches, const HemicubeOptions& options)
    : patches_(patches), options_(options) {
  check(options);
  pixels_ = make_hemicube_pixels(options.resolution);
  const auto n = static_cast<std::size_t>(options.resolution);
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    faces_[f].rows = f == 0 ? options.resolution : options.resolution / 2;
    faces_[f].nearness.resize(n * static_cast<std::size_t>(faces_[f].rows));
    faces_[f].side.resize(faces_[f].nearness.size());
  }
  local_.resize(patches.vertices.size());
  outside_.resize(patches.vertices.size());
  sum_.assign(side_count(patches.size()), 0.0);
}

void Hemicube::row(SideId side, FormFactorRow& row) {
  const auto points = patches_.points(side.patch());
  const auto area = area_vector2(points[0], points[1], points[2]);
  row.entries.clear();
  row.escaped = 1.0;
  if (!(glm::length(area) > 0.0)) return;

  const auto n = (side.is_back() ? -1.0 : 1.0) * glm::normalize(area);
  const Vec3d across(Frame(Vec3(n)).s);
  const auto s = glm::normalize(across - glm::dot(across, n) * n);
  const auto t = glm::cross(n, s);
  std::vector<Vec3d> centres;
  add_centres(Vec3d(points[0]), Vec3d(points[1]), Vec3d(points[2]), options_.points, centres);
  escaped_ = 0.0;
  for (const auto& centre : centres) {
    look(centre + static_cast<double>(origin_lift(points)) * n, s, t, n, side.patch());
    add_up(faces_[0], pixels_.top);
    for (std::size_t f = 1; f < faces_.size(); ++f) add_up(faces_[f], pixels_.side);
  }

  std::sort(met_.begin(), met_.end());
  const auto fraction = 1.0 / static_cast<double>(centres.size());
  for (const auto other : met_) {
    row.entries.push_back({other, static_cast<float>(sum_[other.index()] * fraction)});
    sum_[other.index()] = 0.0;
  }
  met_.clear();
  row.escaped = escaped_ * fraction;
}

void Hemicube::look(const Vec3d& eye, const Vec3d& s, const Vec3d& t, const Vec3d& n,
                    std::uint32_t own_patch) {
  for (auto& face : faces_) {
    std::fill(face.nearness.begin(), face.nearness.end(), 0.0f);
    std::fill(face.side.begin(), face.side.end(), SideId());
  }
  for (std::size_t i = 0; i < local_.size(); ++i) {
    const auto d = Vec3d(patches_.vertices[i]) - eye;
    local_[i] = Vec3(Vec3d(glm::dot(d, s), glm::dot(d, t), glm::dot(d, n)));
    outside_[i] = outside_bits(local_[i]);
  }
  for (std::uint32_t p = 0; p < patches_.size(); ++p) {
    const auto& corners = patches_.corners[p];
    const auto out = outside_[corners[0]] & outside_[corners[1]] & outside_[corners[2]];
    if ((out & below) != 0 || p == own_patch) continue;
    const Vec3d a(local_[corners[0]]), b(local_[corners[1]]), c(local_[corners[2]]);
    Seen seen;
    seen.edge = {glm::cross(a, b), glm::cross(b, c), glm::cross(c, a)};
    const auto volume = glm::dot(a, seen.edge[1]);
    if (volume == 0.0) continue;  // seen edge on
    seen.nearness = (seen.edge[0] + seen.edge[1] + seen.edge[2]) / volume;
    // Along an edge of a solid, faces towards the eye and away from it are equally near; those towards the
    // eye win.
    if (volume < 0.0) seen.nearness *= fronts_first;
    if (volume < 0.0)
      for (auto& edge : seen.edge) edge = -edge;
    seen.side = SideId(p, volume > 0.0);
    for (std::size_t f = 0; f < faces_.size(); ++f)
      if (((out >> (4 * f)) & 15u) == 0) draw(f, seen, corners);
  }
}

// Scan conversion in homogeneous coordinates (Olano and Greer 1997): the edges are planes through the eye, so
// no triangle has to be clipped at a near plane. Two triangles that share an edge compute the same numbers
// for it except for the sign, so no pixel falls between them.
void Hemicube::draw(std::size_t f, const Seen& seen, const std::array<std::uint32_t, 3>& corners) {
  auto& face = faces_[f];
  const auto& axis = axes[f];
  const auto n = options_.resolution;
  const auto step = 2.0 / n;
  const auto u0 = -1.0 + 0.5 * step;                   // centre of column 0
  const auto v0 = (f == 0 ? -1.0 : 0.0) + 0.5 * step;  // and of row 0

  // The rows that the triangle may cover: between its corners, where all of them are in front of the eye.
  auto low = 0.0, high = static_cast<double>(face.rows - 1);
  auto low_v = 1e30, high_v = -1e30;
  bool before = true;
  for (const auto k : corners) {
    const auto w = axis.sign * static_cast<double>(local_[k][axis.w]);
    const auto v = static_cast<double>(local_[k][axis.v]);
    before = before && w > 1e-6 * std::fabs(v) && w > 0.0;
    low_v = std::min(low_v, v / w);
    high_v = std::max(high_v, v / w);
  }
  if (before) {
    low = std::max(low, (low_v - v0) / step - 1e-3);
    high = std::min(high, (high_v - v0) / step + 1e-3);
    if (low > high) return;
  }

  // Value of the plane p, p_u u + p_v v + p_w, as a function of column and row.
  struct Line {
    double column, row, constant;
  };
  const auto line_of = [&](const Vec3d& p) {
    const auto a = p[axis.u], b = p[axis.v], c = axis.sign * p[axis.w];
    return Line{a * step, b * step, (a * u0 + b * v0) + c};
  };
  const std::array<Line, 3> edges = {line_of(seen.edge[0]), line_of(seen.edge[1]), line_of(seen.edge[2])};
  const auto nearness = line_of(seen.nearness);

  const auto last = static_cast<double>(n - 1);
  for (auto row = at_least(low); row <= high; ++row) {
    auto from = 0.0, to = last;
    for (const auto& e : edges) {
      const auto rest = e.row * row + e.constant;
      const auto at = -rest / e.column;
      if (e.column > 0.0)
        from = std::max(from, at);
      else if (e.column < 0.0)
        to = std::min(to, at);
      else if (rest < 0.0)
        to = -1.0;
    }
    if (!(from <= to)) continue;
    const auto first = at_least(from);
    const auto count = static_cast<int>(to) - first + 1;
    const auto start =
        static_cast<std::size_t>(row) * static_cast<std::size_t>(n) + static_cast<std::size_t>(first);
    auto* near = face.nearness.data() + start;
    auto* side = face.side.data() + start;
    const auto begin = static_cast<float>(nearness.column * first + (nearness.row * row + nearness.constant));
    const auto slope = static_cast<float>(nearness.column);
    for (int i = 0; i < count; ++i) {
      const auto here = begin + slope * static_cast<float>(i);
      if (here > near[i]) {
        near[i] = here;
        side[i] = seen.side;
      }
    }
  }
}

void Hemicube::add_up(const Face& face, const std::vector<double>& pixels) {
  for (std::size_t i = 0; i < pixels.size();) {
    const auto side = face.side[i];
    double run = 0.0;
    for (; i < pixels.size() && face.side[i] == side; ++i) run += pixels[i];
    if (!side) {
      escaped_ += run;
    } else {
      if (sum_[side.index()] == 0.0) met_.push_back(side);
      sum_[side.index()] += run;
    }
  }
}

}  // namespace luxel
