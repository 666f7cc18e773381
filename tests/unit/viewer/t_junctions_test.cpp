// SPDX-License-Identifier: Apache-2.0
// Drawing of a mesh with T-junctions: no background between its patches, and unchanged light.
#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "luxel/viewer/draw_vertices.h"
#include "luxel/viewer/frame.h"
#include "luxel/viewer/surfaces.h"

#include "support/lit_patches.h"
#include "support/off_screen.h"

namespace luxel {
namespace {

constexpr ScreenSize size{512, 512};
constexpr int pieces = 23;
const Space z_up(Vec3(0.0f, 0.0f, 1.0f));
const Pose before_it{.eye = Vec3(0.0f, -2.0f, 0.0f)};

// A round slice of a wall, y = 0: a disc of a few large patches, and around it a ring whose inner edges end
// within those of the disc.
test::LitPatches disc_and_ring() {
  test::LitPatches lit;
  const auto place = [](float radius, float angle) {
    return Vec3(radius * std::cos(angle), 0.0f, radius * std::sin(angle));
  };
  constexpr int sides = 5;
  constexpr float turn = 0.1f, step = 2.0f * pi / sides;
  const auto middle = lit.vertex(Vec3(0.0f));
  for (int i = 0; i < sides; ++i) {
    const auto a = place(0.5f, turn + step * static_cast<float>(i)),
               b = place(0.5f, turn + step * static_cast<float>(i + 1));
    const auto from = lit.vertex(a), to = lit.vertex(b);
    lit.patch({middle, from, to}, 1.0f);
    // Outer vertex k lies beyond the middle of the piece from inner vertex k to k + 1.
    std::vector<std::uint32_t> inner = {from}, outer;
    for (int k = 0; k < pieces; ++k) {
      const auto at = [&](float f) { return a + f / pieces * (b - a); };
      inner.push_back(k + 1 == pieces ? to : lit.vertex(at(static_cast<float>(k + 1))));
      outer.push_back(lit.vertex(2.2f * at(static_cast<float>(k) + 0.5f)));
    }
    for (std::size_t k = 0; k < pieces; ++k) {
      lit.patch({inner[k + 1], inner[k], outer[k]}, 1.0f);
      if (k + 1 < pieces) lit.patch({inner[k + 1], outer[k], outer[k + 1]}, 1.0f);
    }
  }
  return lit;
}

class TJunctions : public test::OffScreen {
 protected:
  TJunctions() : OffScreen(size) {}

  void set_up() override {
    patches_ = std::make_shared<PatchSet>(lit_.patches);
    surfaces_ = std::make_unique<Surfaces>();
    surfaces_->set_mesh(patches_);
  }
  // Number of pixels that show the background. The disc's border is between 0.40 and 0.5 m from the middle;
  // the ring has gaps beyond its corners.
  int holes(Paint paint) {
    while (!surfaces_->upload(1.0)) {
    }
    constexpr float inside = 0.48f;  // m
    int count = 0;
    // Edges round differently from each view.
    for (const float turn : {0.0f, 0.013f, 0.037f, 0.11f}) {
      const Pose pose{.eye = before_it.eye, .turn = turn, .pitch = 0.5f * turn};
      DrawnFrame frame;
      frame.begin(size, Vec3(0.0f), EdgeSmoothing::rough);
      surfaces_->draw({.projection = projection(pose, z_up, {Vec3(-1), Vec3(1)}, 1.0f),
                       .eye = pose.eye,
                       .paint = paint,
                       .tone = {{.op = ToneOperator::clamp}, 10.0f}});
      frame.resolve();
      const auto image = frame.read();
      for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
          const auto seen = sight(pose, z_up, 1.0f, 2.0f * (static_cast<float>(x) + 0.5f) / 512.0f - 1.0f,
                                  1.0f - 2.0f * (static_cast<float>(y) + 0.5f) / 512.0f);
          const auto at = seen.origin - seen.origin.y / seen.direction.y * seen.direction;
          if (glm::length(at) < inside && image.at(x, y).g < 0.05f) ++count;
        }
    }
    return count;
  }

  test::LitPatches lit_ = disc_and_ring();
  std::shared_ptr<const PatchSet> patches_;
  std::unique_ptr<Surfaces> surfaces_;
};

TEST_F(TJunctions, show_nothing_of_what_lies_behind) {
  EXPECT_EQ(holes(Paint::sides), 0);
  surfaces_->set_light(patches_,
                       std::make_shared<SmoothLight>(make_smooth_light(lit_.patches, lit_.solution)),
                       VertexValue::radiance);
  EXPECT_EQ(holes(Paint::light), 0);
}

TEST_F(TJunctions, values_of_patches_stay_with_their_patches) {
  std::vector<float> values;
  for (std::size_t p = 0; p < patches_->size(); ++p) {
    const bool is_of_disc = patches_->corners[p][0] == 0;  // its middle
    values.insert(values.end(), 2, is_of_disc ? 1.0f : 0.0f);
  }
  surfaces_->set_side_values(std::make_shared<std::vector<float>>(values));
  while (!surfaces_->upload(1.0)) {
  }
  DrawnFrame frame;
  const ValueScale scale{.low = 0.0f, .high = 1.0f};
  frame.begin(size, Vec3(0.0f), EdgeSmoothing::rough);
  surfaces_->draw({.projection = projection(before_it, z_up, {Vec3(-1), Vec3(1)}, 1.0f),
                   .eye = before_it.eye,
                   .paint = Paint::patches,
                   .scale = scale});
  frame.resolve();
  const auto image = frame.read();
  const auto expect_at = [&](const Vec3& place, float value) {
    const auto clip = projection(before_it, z_up, {Vec3(-1), Vec3(1)}, 1.0f) * Vec4(place, 1.0f);
    const auto x = static_cast<int>(256.0f * (1.0f + clip.x / clip.w)),
               y = static_cast<int>(256.0f * (1.0f - clip.y / clip.w));
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(image.at(x, y)[c], map_colour(scale.map, value)[c], 0.01f) << x << " " << y;
  };
  for (int i = 0; i < 40; ++i) {
    const float angle = 0.157f * static_cast<float>(i);
    expect_at(0.3f * Vec3(std::cos(angle), 0.0f, std::sin(angle)), 1.0f);
    expect_at(0.6f * Vec3(std::cos(angle), 0.0f, std::sin(angle)), 0.0f);
  }
}

TEST(DrawVertices, a_vertex_within_an_edge_has_the_ends_of_it) {
  const auto lit = disc_and_ring();
  const auto light = make_smooth_light(lit.patches, lit.solution);
  const auto cuts = cut_at_hanging_vertices(lit.patches);
  ASSERT_EQ(cuts.size(), 5u);
  DrawVertices found(lit.patches, cuts, light);
  while (!found.is_done()) found.go_on(7);
  int on_edge = 0;
  for (std::uint32_t v = 0; v < found.vertices().size(); ++v) {
    const auto& vertex = found.vertices()[v];
    if (!vertex.is_on_edge()) continue;
    ++on_edge;
    EXPECT_LT(vertex.from, v);
    EXPECT_LT(vertex.to, v);
    const auto from = found.place(found.vertices()[vertex.from]),
               to = found.place(found.vertices()[vertex.to]);
    EXPECT_LT(glm::length(from + vertex.fraction * (to - from) - found.place(vertex)), 1e-5f);
  }
  EXPECT_EQ(on_edge, 5 * (pieces - 1));
  EXPECT_EQ(found.corners().size(), lit.patches.size());
  EXPECT_EQ(found.triangles().size(), lit.patches.size() + 5 * (pieces - 1));
  EXPECT_EQ(drawn_triangles(lit.patches, cuts).size(), found.triangles().size());
  EXPECT_EQ(patches_of_triangles(lit.patches, cuts).size(), found.triangles().size());
}

}  // namespace
}  // namespace luxel
