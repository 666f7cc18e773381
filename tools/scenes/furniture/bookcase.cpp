// SPDX-License-Identifier: Apache-2.0
#include "scenes/furniture/bookcase.h"

#include <array>
#include <cmath>

#include "scenes/furniture/tables.h"
#include "scenes/shapes/dice.h"
#include "scenes/shapes/solids.h"

namespace luxel::scenes {
namespace {

constexpr auto width = 1.9;
constexpr auto height = 2.2;
constexpr auto depth = 0.32;
constexpr auto board = 0.026;
constexpr auto joint = 0.001;  // boards stand this far apart: no two faces in one place
constexpr auto foot = 0.07;    // m; the lowest shelf above the floor
constexpr auto rows = 5;

constexpr auto bay_width = (width - 3.0 * board) / 2.0;
constexpr auto row_height = (height - foot - board) / rows;

double shelf_top(int row) { return foot + board + row * row_height; }
double bay_left(int bay) { return bay == 0 ? -0.5 * width + board : 0.5 * board; }

Mesh at(const Vec3d& size, const Vec3d& where) { return placed(box(size), where); }

constexpr std::array bindings = {
    Paint::book_red,   Paint::book_blue,   Paint::book_green, Paint::book_yellow,     Paint::book_black,
    Paint::book_white, Paint::book_orange, Paint::plum_cloth, Paint::glaze_turquoise, Paint::clay};

// Books of one series share height and colour, as on real shelves.
struct Series {
  double height, depth, thickness;
  std::uint64_t binding;
  int volumes;
};

Series series_at(std::uint64_t address) {
  const auto sets = dice(11, address, 4) < 0.22;
  return {.height = dice_between(0.19, 0.335, 11, address, 0),
          .depth = dice_between(0.14, 0.22, 11, address, 1),
          .thickness = dice_between(0.026, 0.068, 11, address, 2),
          .binding = address * 31u + 7u,
          .volumes = sets ? 3 + static_cast<int>(3.0 * dice(11, address, 5)) : 1};
}

// Fills a bay from its left to its right end, where end leaves room for something else.
void add_row_of_books(Mesh& mesh, std::uint64_t address, double left, double end, double y) {
  auto x = left + 0.003;
  for (auto k = 0u; x < end; ++k) {
    const auto series = series_at(1000u * address + k);
    for (auto volume = 0; volume < series.volumes; ++volume) {
      if (x + series.thickness + joint > end) return;
      const auto z = 0.5 * series.depth + 0.02 + 0.05 * dice(12, 1000u * address + k);
      const auto size = Vec3d(series.thickness, series.height, series.depth);
      append(mesh, placed(standing_book(series.binding, size), {x + 0.5 * series.thickness, y, z}));
      x += series.thickness + joint;
    }
  }
}

// What stands in the gap that the books of this bay leave, seldom nothing.
Mesh ornament(int row, int bay) {
  switch ((2 * row + bay) % 5) {
    case 0:
      return vase(Paint::glaze_turquoise, 0.28);
    case 1:
      return bellied_vase(Paint::clay, 0.20);
    case 2:
      return lying_books(static_cast<std::uint64_t>(40 + row), 4);
    case 3:
      return bellied_vase(Paint::glaze_cobalt, 0.24);
    default:
      return bowl(Paint::porcelain, 0.13);
  }
}

}  // namespace

Mesh bookcase() {
  const auto y = height + joint;
  auto mesh = Mesh{};
  for (const auto x : {-0.5 * (width - board), 0.0, 0.5 * (width - board)}) {
    append(mesh, at({board, height, depth}, {x, 0.0, 0.5 * depth}));
  }
  append(mesh, at({width + 0.02, board, depth + 0.01}, {0.0, y, 0.5 * depth + 0.005}));
  for (auto bay = 0; bay < 2; ++bay) {
    const auto middle = bay_left(bay) + 0.5 * bay_width;
    const auto inside = bay_width - 2.0 * joint;
    for (auto row = 0; row < rows; ++row) {
      append(mesh, at({inside, board, depth - 0.02}, {middle, shelf_top(row) - board, 0.5 * depth + 0.005}));
    }
    append(mesh, at({inside, height - foot - joint, 0.008}, {middle, foot, 0.006}));
  }
  return painted(std::move(mesh), Paint::walnut);
}

Mesh books_of_bookcase() {
  auto mesh = Mesh{};
  for (auto row = 0; row < rows; ++row) {
    for (auto bay = 0; bay < 2; ++bay) {
      const auto address = static_cast<std::uint64_t>(2 * row + bay);
      const auto y = shelf_top(row) + joint;
      const auto left = bay_left(bay);
      const auto with_ornament = dice(13, address) < 0.5;
      const auto end = left + bay_width - 0.006 - (with_ornament ? 0.33 : 0.0);
      add_row_of_books(mesh, address, left, end, y);
      if (with_ornament) append(mesh, placed(ornament(row, bay), {left + bay_width - 0.17, y, 0.18}));
    }
  }
  return mesh;
}

Mesh standing_book(std::uint64_t which, const Vec3d& size) {
  // Seen from above: straight boards, and a spine of three facets that bulges by an eighth of its thickness.
  constexpr auto facets = 3;
  const auto half = 0.5 * size.x;
  const auto spine = 0.5 * size.z;
  auto outline = std::vector<glm::dvec2>{{half, spine}, {-half, spine}};
  for (auto k = 0; k <= facets; ++k) {
    const auto x = 2.0 * k / facets - 1.0;
    outline.emplace_back(half * x, -spine + 0.25 * half * x * x);
  }
  const auto binding = static_cast<std::size_t>(dice(14, which) * bindings.size());
  const auto lying = painted(prism(outline, size.y), bindings[binding]);
  const auto book = turned_x(lying, -90.0);
  return painted(book, Paint::paper, [](const Vec3d&, const Vec3d& normal) { return normal.y > 0.9; });
}

}  // namespace luxel::scenes
