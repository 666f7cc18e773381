// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/image/pack_shapes.h"
#include "luxel/surface/make_charts.h"
#include "luxel/surface/pack_charts.h"
#include "luxel/surface/texel_support.h"

#include "support/chart_checks.h"
#include "support/lightmap_scenes.h"

namespace luxel {
namespace {

using test::add_box;
using test::add_room;
using test::charts_of;
using test::expect_every_front_once;
using test::expect_no_overlap;

// The texels that lookups read: each in one chart, and with margins between all and to the edge. Returns the
// part of the pages that they cover.
double expect_apart(const Charts& charts, const Atlas& atlas) {
  const auto size = atlas.page_size;
  std::vector<std::vector<std::uint32_t>> owner(static_cast<std::size_t>(atlas.pages));
  for (auto& page : owner) page.assign(static_cast<std::size_t>(size * size), none);
  const auto for_texels = [&](const auto& body) {
    for (std::uint32_t c = 0; c < charts.charts.size(); ++c)
      for (const auto side : charts.charts[c].sides) {
        std::array<glm::dvec2, 3> t;
        for (std::size_t k = 0; k < 3; ++k) t[k] = glm::dvec2(atlas.corners[side.index()][k]) - 0.5;
        const auto& place = atlas.places[c];
        const auto low = glm::floor(glm::min(glm::min(t[0], t[1]), t[2])) - 1.0;
        const auto high = glm::ceil(glm::max(glm::max(t[0], t[1]), t[2])) + 1.0;
        for (auto y = static_cast<int>(low.y); y <= static_cast<int>(high.y); ++y)
          for (auto x = static_cast<int>(low.x); x <= static_cast<int>(high.x); ++x)
            if (is_read_from(t, {x, y}, filling_rounding)) body(c, place.page, x, y);
        for (const auto& corner : t) {  // what is read lies in the chart's box
          EXPECT_GE(std::min(corner.x - place.x, corner.y - place.y), -1e-3);
          EXPECT_LE(std::max(corner.x - place.x - place.width, corner.y - place.y - place.height),
                    -1.0 + 1e-3);
        }
      }
  };
  std::size_t covered = 0, beyond = 0, shared = 0, near = 0;
  for_texels([&](std::uint32_t c, std::uint32_t page, int x, int y) {
    if (std::min(x, y) < atlas.margin || std::max(x, y) >= size - atlas.margin) {
      ++beyond;
      return;
    }
    auto& texel = owner[page][static_cast<std::size_t>(y * size + x)];
    covered += texel == none ? 1 : 0;
    shared += texel != none && texel != c ? 1 : 0;
    texel = c;
  });
  for (const auto& page : owner)
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const auto c = page[static_cast<std::size_t>(y * size + x)];
        if (c == none) continue;
        for (int j = y - atlas.margin; j <= y + atlas.margin; ++j)
          for (int i = x - atlas.margin; i <= x + atlas.margin; ++i) {
            const auto other = page[static_cast<std::size_t>(j * size + i)];
            near += other != none && other != c ? 1 : 0;
          }
      }
  EXPECT_EQ(beyond, 0u);
  EXPECT_EQ(shared, 0u);
  EXPECT_EQ(near, 0u);
  return static_cast<double>(covered) / (static_cast<double>(size) * size * atlas.pages);
}

TEST(LightmapPages, hold_charts_apart_and_to_the_scale_asked_for) {
  truth::SceneBuilder b;
  add_room(b, {0, 0, 0}, {4, 3, 2.5f}, 0.5f);
  b.material("box", 0.5f, 0.0f);
  add_box(b, {1.13f, 1.27f, 0}, {2.21f, 2.4f, 1});
  const auto patches = make_patches(b.scene(), {.max_edge = 0.5f});
  const auto charts = charts_of(patches, 0.05f);
  for (const int page : {96, 128, 1024}) {
    const auto atlas = pack_charts(patches, charts, {.texel = 0.05f, .page_size = page, .margin = 3});
    const auto use = expect_apart(charts, atlas);
    EXPECT_TRUE(use > 0.65 || page < 1024) << use;
    EXPECT_EQ(atlas.pages > 1, page < 1024);
    double texels = 0.0, area = 0.0;
    for (std::size_t p = 0; p < patches.size(); ++p) {
      const auto& t = atlas.corners[2 * p];
      const auto u = t[1] - t[0], v = t[2] - t[0];
      const auto own = 0.5 * std::abs(u.x * v.y - u.y * v.x);
      const auto needed = static_cast<double>(patches.area[p]) / (0.05 * 0.05);
      EXPECT_GE(own, 0.99 * needed);
      EXPECT_LE(own, 1.10 * needed);  // a box of 1.08 m: 21.6 texels become 22
      texels += own;
      area += needed;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto uv = atlas.uv(SideId(p, false), k);
        EXPECT_TRUE(uv.x > 0.0f && uv.y > 0.0f && uv.x < 1.0f && uv.y < 1.0f);
      }
    }
    EXPECT_NEAR(texels / area, 1.0, 0.02);
  }
}

TEST(LightmapPages, are_as_small_as_a_multiple_of_four_allows) {
  const auto patches = make_patches(truth::cube({}), {.max_edge = 0.5f});
  const auto charts = charts_of(patches, 0.1f);
  const auto atlas = pack_charts(patches, charts, {.texel = 0.1f, .page_size = 1024, .margin = 2});
  EXPECT_EQ(atlas.pages, 1);
  EXPECT_EQ(atlas.page_size, 44);  // six charts of 11 x 11 and their margins need 41 by 28
}

// Columns with steps, tables and chairs: many things that bend, and stand on each other.
Scene furnished_room() {
  truth::SceneBuilder b;
  add_room(b, {0, 0, 0}, {6, 5, 3}, 0.5f);
  b.material("things", 0.5f, 0.0f);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const Vec3 at(0.8f + 1.9f * static_cast<float>(i), 0.7f + 1.5f * static_cast<float>(j), 0.0f);
      add_box(b, at, at + Vec3(0.05f, 0.05f, 0.7f));
      add_box(b, at + Vec3(-0.2f, -0.2f, 0.7f), at + Vec3(0.4f, 0.3f, 0.74f));
      constexpr int slices = 12;
      const auto foot = at + Vec3(0.9f, 0.4f, 0.0f);
      const auto around = [&](int k, float z) {
        const auto angle = 2.0 * M_PI * (k % slices) / slices;
        return foot + Vec3(0.15f * std::cos(angle), 0.15f * std::sin(angle), z);
      };
      for (int k = 0; k < slices; ++k)
        b.quad(around(k, 0.0f), around(k + 1, 0.0f), around(k + 1, 0.9f), around(k, 0.9f));
    }
  return b.scene();
}

// 2 x 9 boxes of six faces and nine cylinders of six charts at most, in a room of six: none more by
// contacts.
TEST(LightmapPages, of_a_furnished_room_are_few_charts_evenly_dense_on_full_pages) {
  const auto scene = furnished_room();
  for (const float max_edge : {no_max_edge, 0.3f}) {
    const auto patches = make_patches(scene, {.max_edge = max_edge});
    const auto charts = charts_of(patches, 0.03f);
    EXPECT_LE(charts.charts.size(), 6u + 2u * 9u * 6u + 9u * 6u);
    expect_every_front_once(patches, charts);
    expect_no_overlap(patches, charts);
    const auto atlas = pack_charts(patches, charts, {.texel = 0.03f, .page_size = 1024, .margin = 2});
    EXPECT_EQ(atlas.pages, 1);
    EXPECT_GT(expect_apart(charts, atlas), 0.65);

    std::vector<std::pair<double, double>> density;  // texels per metre, m²
    double all = 0.0;
    for (std::size_t p = 0; p < patches.size(); ++p) {
      const auto& t = atlas.corners[2 * p];
      const auto u = t[1] - t[0], v = t[2] - t[0];
      const auto area = static_cast<double>(patches.area[p]);
      density.emplace_back(std::sqrt(0.5 * std::abs(u.x * v.y - u.y * v.x) / area), area);
      all += area;
    }
    std::sort(density.begin(), density.end());
    double below = 0.0;
    for (const auto& [texels, area] : density) {
      below += area;
      if (below > 0.05 * all && below < 0.95 * all) {
        EXPECT_GE(texels, 0.95 / 0.03);
        EXPECT_LE(texels, 1.10 / 0.03);
      }
    }
  }
}

// Whether two shapes, and the edge of the page, have `margin` pixels between them.
TEST(PackShapes, shapes_are_packed_apart_and_turned_without_change) {
  std::vector<PixelShape> shapes;
  for (int i = 0; i < 120; ++i) {
    PixelShape shape(3 + i * 7 % 23, 2 + i * 13 % 31);
    for (int y = 0; y < shape.height(); ++y)  // a triangle, or a frame
      for (int x = 0; x < shape.width(); ++x)
        if (i % 2 == 0 ? x * shape.height() <= (y + 1) * shape.width()
                       : x == 0 || y == 0 || x == shape.width() - 1 || y == shape.height() - 1)
          shape.add(x, y);
    shapes.push_back(shape);
  }
  constexpr int size = 96, margin = 2;
  const auto packed = pack_shapes(shapes, size, margin, 100);
  ASSERT_GE(packed.pages, 1);
  std::vector<std::vector<int>> owner(static_cast<std::size_t>(packed.pages),
                                      std::vector<int>(size * size, -1));
  const auto for_pixels = [&](const auto& body) {
    for (std::size_t i = 0; i < shapes.size(); ++i)
      for (int y = 0; y < shapes[i].height(); ++y)
        for (int x = 0; x < shapes[i].width(); ++x) {
          if (!shapes[i].has(x, y)) continue;
          const auto& at = packed.shapes[i];
          const auto [tx, ty] =
              turned_place(at.quarters, x, y, shapes[i].width() - 1, shapes[i].height() - 1);
          EXPECT_TRUE(shapes[i].turned(at.quarters).has(tx, ty));
          body(static_cast<int>(i), static_cast<std::size_t>(at.page), at.x + tx, at.y + ty);
        }
  };
  std::size_t pixels = 0;
  for_pixels([&](int i, std::size_t page, int x, int y) {
    ASSERT_GE(std::min(x, y), margin);
    ASSERT_LT(std::max(x, y), size - margin);
    EXPECT_EQ(owner[page][static_cast<std::size_t>(y * size + x)], -1);
    owner[page][static_cast<std::size_t>(y * size + x)] = i;
    ++pixels;
  });
  for_pixels([&](int i, std::size_t page, int x, int y) {
    for (int dy = -margin; dy <= margin; ++dy)
      for (int dx = -margin; dx <= margin; ++dx) {
        const auto other = owner[page][static_cast<std::size_t>((y + dy) * size + x + dx)];
        EXPECT_TRUE(other == -1 || other == i);
      }
  });
  std::size_t expected = 0;
  for (const auto& shape : shapes) expected += shape.count();
  EXPECT_EQ(pixels, expected);
  EXPECT_EQ(pack_shapes(shapes, size, margin, packed.pages).pages, packed.pages);
  EXPECT_EQ(pack_shapes(shapes, size, margin, packed.pages - 1).pages, 0);
  EXPECT_EQ(pack_shapes(shapes, 20, margin, 100).pages, 0);  // larger than a page
}

}  // namespace
}  // namespace luxel
