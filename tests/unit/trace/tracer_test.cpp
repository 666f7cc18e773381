// SPDX-License-Identifier: Apache-2.0
#include "luxel/trace/tracer.h"

#include <gtest/gtest.h>

#include "luxel/core/address.h"
#include "luxel/patch/make_patches.h"
#include "luxel/patch/side.h"
#include "luxel/trace/patch_emitter.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

TEST(Tracer, says_what_is_hit_where_and_from_which_side) {
  const auto patches = make_patches(truth::plates(), {.max_edge = no_max_edge});
  const Context context(1);
  const Tracer tracer(patches, context);
  const auto up = tracer.nearest({{0.75f, 0.25f, 0.5f}, {0, 0, 1}});
  ASSERT_TRUE(up);
  EXPECT_EQ(patches.material_of(up.patch).name, "upper");
  EXPECT_FALSE(up.back);
  EXPECT_FLOAT_EQ(up.distance, 0.5f);
  const auto [a, b, c] = patches.points(up.patch);
  const auto point = (1.0f - up.u - up.v) * a + up.u * b + up.v * c;
  EXPECT_NEAR(glm::distance(point, Vec3(0.75f, 0.25f, 1.0f)), 0.0f, 1e-6f);

  const auto from_above = tracer.nearest({{0.5f, 0.25f, 3.0f}, {0, 0, -1}});
  ASSERT_TRUE(from_above);
  EXPECT_TRUE(from_above.back);
  EXPECT_FALSE(tracer.nearest({{0.5f, 0.25f, 3.0f}, {0, 0, 1}}));
}

TEST(Tracer, knows_what_stands_in_the_way) {
  const auto patches = make_patches(truth::plates(), {.max_edge = no_max_edge});
  const Context context(1);
  const Tracer tracer(patches, context);
  const Ray ray{{0.3f, 0.6f, 0.5f}, {0, 0, 1}};
  EXPECT_TRUE(tracer.occluded(ray, 0.6f));
  EXPECT_FALSE(tracer.occluded(ray, 0.4f));
}

// A closed cube far from the origin and near it, in micrometres and in kilometres: no ray leaves, and none
// meets the wall it starts on.
TEST(Tracer, behaves_alike_at_every_scale) {
  for (const float size : {1e-6f, 1e-3f, 1.0f, 1e3f, 1e6f}) {
    auto scene = truth::cube({}, size);
    const auto patches = make_patches(scene, {.max_edge = 0.15f * size});
    const Context context(1);
    const Tracer tracer(patches, context);
    std::size_t escaped = 0;
    std::size_t own_wall = 0;
    for (std::size_t p = 0; p < patches.size(); ++p) {
      const PatchEmitter emitter(patches, SideId(p, false));
      for (std::size_t i = 0; i < 500; ++i) {
        const auto hit =
            tracer.nearest(emitter.ray(uniform4(stream_key(1, 0, static_cast<std::uint32_t>(p)), i)));
        escaped += !hit;
        own_wall += hit && patches.material[hit.patch] == patches.material[p];
      }
    }
    EXPECT_EQ(escaped, 0u) << "size " << size;
    EXPECT_EQ(own_wall, 0u) << "size " << size;
  }
}

TEST(Tracer, many_rays_get_the_hits_of_each_one_alone) {
  const auto patches = make_patches(truth::l_room(), {.max_edge = 0.1f});
  const Context context(1);
  const Tracer tracer(patches, context);
  std::vector<Ray> rays;
  for (std::size_t p = 0; p < patches.size(); ++p)
    rays.push_back(PatchEmitter(patches, SideId(p, p % 3 == 0)).ray(uniform4(stream_key(1, 0, 0), p)));
  std::vector<Hit> hits(rays.size());
  tracer.nearest(rays, hits);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const auto one = tracer.nearest(rays[i]);
    EXPECT_EQ(hits[i].patch, one.patch);
    EXPECT_EQ(hits[i].back, one.back);
    EXPECT_EQ(hits[i].distance, one.distance);
  }
}

}  // namespace
}  // namespace luxel
