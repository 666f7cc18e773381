// SPDX-License-Identifier: Apache-2.0
#include "showpiece/pictures.h"

#include <cmath>

#include "showpiece/sheets.h"
#include "showpiece/sweeping.h"

namespace luxel::showpiece {
namespace {

constexpr auto first_layer = 0.006;  // m off the wall
constexpr auto layer = 0.002;        // m from one paper to the next

// A hill across the sheet: paper from the lower edge up to a wave.
Mesh hill(double width, double height, double top, double swing, double phase, Paint paint) {
  return painted(sheet(24, 1,
                       [&](double s, double t) {
                         const auto wave = top + swing * std::sin(phase + 4.4 * s);
                         return Vec3d((s - 0.5) * width, (-0.5 + t * wave) * height, 0.0);
                       }),
                 paint);
}

Mesh stacked(const std::vector<Mesh>& papers) {
  auto mesh = Mesh{};
  for (std::size_t k = 0; k < papers.size(); ++k) {
    append(mesh, moved(papers[k], {0.0, 0.0, first_layer + layer * static_cast<double>(k)}));
  }
  return mesh;
}

Mesh ground(double width, double height, Paint paint) {
  return painted(panel({-0.5 * width, -0.5 * height, 0.0}, {width, 0.0, 0.0}, {0.0, height, 0.0},
                       {0.0, 0.5, 1.0}, {0.0, 0.5, 1.0}),
                 paint);
}

Mesh sun(double radius, const Vec3d& at, Paint paint) { return painted(moved(disc(radius), at), paint); }

Mesh arch(double radius, double thickness, double foot, Paint paint) {
  return painted(moved(disc(radius, radius - thickness, 0.0, 180.0), {0.0, foot, 0.0}), paint);
}

}  // namespace

Mesh picture_frame(double width, double height, Paint wood) {
  constexpr auto off_wall = 0.001;
  return painted(
      frame(
          width, height,
          {{0.0, off_wall}, {0.026, off_wall}, {0.026, 0.022}, {0.020, 0.027}, {0.006, 0.024}, {0.0, 0.018}}),
      wood);
}

Mesh picture_sheet(double width, double height, Motif motif) {
  const auto w = width - 0.002;
  const auto h = height - 0.002;
  switch (motif) {
    case Motif::sunset:
      return stacked(
          {ground(w, h, Paint::paper), sun(0.24 * w, {0.10 * w, 0.14 * h, 0.0}, Paint::book_orange),
           hill(w, h, 0.46, 0.06, 0.4, Paint::coral_cloth), hill(w, h, 0.34, 0.07, 2.6, Paint::plum_cloth),
           hill(w, h, 0.20, 0.05, 4.4, Paint::rug_indigo)});
    case Motif::rainbow:
      return stacked({ground(w, h, Paint::paper),
                      sun(0.10 * w, {0.24 * w, 0.32 * h, 0.0}, Paint::ochre_cloth),
                      joined({arch(0.38 * w, 0.085 * w, -0.24 * h, Paint::rug_rust),
                              arch(0.27 * w, 0.075 * w, -0.24 * h, Paint::ochre_cloth),
                              arch(0.17 * w, 0.07 * w, -0.24 * h, Paint::glaze_turquoise)})});
    case Motif::moon:
      break;
  }
  return stacked(
      {ground(w, h, Paint::rug_indigo), sun(0.22 * w, {-0.06 * w, 0.16 * h, 0.0}, Paint::book_yellow),
       hill(w, h, 0.40, 0.08, 1.2, Paint::teal_cloth), hill(w, h, 0.24, 0.06, 3.6, Paint::paper_dark)});
}

}  // namespace luxel::showpiece
