// SPDX-License-Identifier: Apache-2.0
#include "scenes/furniture/pictures.h"

#include <algorithm>
#include <cmath>

#include "scenes/shapes/sheets.h"
#include "scenes/shapes/sweeping.h"

namespace luxel::scenes {
namespace {

constexpr auto off_wall = 0.006;  // m
constexpr auto on_top = 0.002;    // m from the papers to what is glued on them

// A line across the sheet, s from left (0) to right (1): its height, in sheet heights from the sheet's
// middle.
struct Wave {
  double above_foot, swing, phase;
  double operator()(double s) const { return above_foot - 0.5 + swing * std::sin(phase + 4.4 * s); }
};
constexpr auto foot = Wave{0.0, 0.0, 0.0};
constexpr auto top = Wave{1.0, 0.0, 0.0};

// Papers meet at their waves and do not overlap: what hides behind another would lie in the dark.
struct Paper {
  Wave upper_edge;
  Paint paint;
};

// From the lowest to the highest.
Mesh papers(const glm::dvec2& size, const std::vector<Paper>& upwards) {
  auto mesh = Mesh{};
  auto low = foot;
  for (const auto& piece : upwards) {
    const auto& high = piece.upper_edge;
    // Cells about as high as wide: slivers carry light along themselves.
    const auto rows = 1 + static_cast<int>(4.0 * (high.above_foot - low.above_foot));
    const auto strip = sheet(12, rows, [&](double s, double t) {
      return Vec3d((s - 0.5) * size.x, size.y * ((1.0 - t) * low(s) + t * high(s)), off_wall);
    });
    append(mesh, painted(strip, piece.paint));
    low = high;
  }
  return mesh;
}

Mesh glued(Mesh shape, const Vec3d& at, Paint paint) {
  return painted(moved(std::move(shape), at + Vec3d(0.0, 0.0, off_wall + on_top)), paint);
}

Mesh sunset(const glm::dvec2& size) {
  return joined({papers(size, {{{0.19, 0.05, 4.4}, Paint::rug_indigo},
                               {{0.33, 0.05, 2.6}, Paint::plum_cloth},
                               {{0.46, 0.06, 0.4}, Paint::coral_cloth},
                               {top, Paint::paper}}),
                 glued(disc(0.22 * std::min(size.x, size.y)), {0.10 * size.x, 0.22 * size.y, 0.0},
                       Paint::book_orange)});
}

Mesh rainbow(const glm::dvec2& size) {
  const auto w = size.x;
  const auto ground = Vec3d(0.0, -0.24 * size.y, 0.0);
  auto arch = [&](double radius, double thickness) { return disc(radius, radius - thickness, 0.0, 180.0); };
  return joined({papers(size, {{top, Paint::paper}}),
                 glued(arch(0.38 * w, 0.085 * w), ground, Paint::rug_rust),
                 glued(arch(0.27 * w, 0.075 * w), ground, Paint::ochre_cloth),
                 glued(arch(0.17 * w, 0.07 * w), ground, Paint::glaze_turquoise),
                 glued(disc(0.10 * w), {0.24 * w, 0.32 * size.y, 0.0}, Paint::ochre_cloth)});
}

Mesh moon(const glm::dvec2& size) {
  return joined({papers(size, {{{0.24, 0.06, 3.6}, Paint::paper_dark},
                               {{0.40, 0.08, 1.2}, Paint::teal_cloth},
                               {top, Paint::rug_indigo}}),
                 glued(disc(0.22 * size.x), {-0.06 * size.x, 0.18 * size.y, 0.0}, Paint::book_yellow)});
}

}  // namespace

Mesh picture_frame(double width, double height, Paint wood) {
  constexpr auto back = 0.001;
  return painted(
      frame(width, height,
            {{0.0, back}, {0.026, back}, {0.026, 0.022}, {0.020, 0.027}, {0.006, 0.024}, {0.0, 0.018}}),
      wood);
}

Mesh picture_sheet(double width, double height, Motif motif) {
  const auto size = glm::dvec2(width, height) - 0.002;  // a joint away from the frame
  switch (motif) {
    case Motif::sunset:
      return sunset(size);
    case Motif::rainbow:
      return rainbow(size);
    case Motif::moon:
      break;
  }
  return moon(size);
}

}  // namespace luxel::scenes
