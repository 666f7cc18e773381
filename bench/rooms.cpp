// SPDX-License-Identifier: Apache-2.0
#include "bench/rooms.h"

#include "luxel/random/address.h"

namespace luxel::bench {
namespace {

class Builder {
 public:
  void material(const char* name, float reflectance, float emittance) {
    scene_.materials.push_back({name, Vec3(reflectance), Vec3(emittance), true});
  }
  void quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const auto first = static_cast<std::uint32_t>(scene_.positions.size());
    scene_.positions.insert(scene_.positions.end(), {a, b, c, d});
    for (const auto& t : {std::array{first, first + 1, first + 2}, std::array{first, first + 2, first + 3}}) {
      scene_.triangles.push_back(t);
      scene_.triangle_material.push_back(static_cast<MaterialId>(scene_.materials.size() - 1));
      scene_.triangle_line.push_back(0);
      scene_.triangle_group.push_back(0);
    }
  }
  // Six faces; outwards, or inwards for a room.
  void box(const Vec3& low, const Vec3& high, bool inwards) {
    const auto corner = [&](int i) {
      return Vec3(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
    };
    constexpr int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                 {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& f : faces)
      inwards ? quad(corner(f[3]), corner(f[2]), corner(f[1]), corner(f[0]))
              : quad(corner(f[0]), corner(f[1]), corner(f[2]), corner(f[3]));
  }
  Scene take() {
    scene_.source = "bench";
    scene_.groups = {"default"};
    return std::move(scene_);
  }

 private:
  Scene scene_;
};

void add_lamp(Builder& builder, int triangles) {
  int side = 1;
  while (2 * side * side < triangles) side *= 2;
  const float step = 1.0f / static_cast<float>(side);
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const float x = 2.5f + step * static_cast<float>(i);
      const float y = 2.0f + step * static_cast<float>(j);
      const float z = 2.9f;
      builder.quad({x, y, z}, {x, y + step, z}, {x + step, y + step, z}, {x + step, y, z});  // faces down
    }
}

}  // namespace

Scene furnished_room(int boxes, int lamp_triangles) {
  Builder builder;
  builder.material("walls", 0.7f, 0.0f);
  builder.box({0, 0, 0}, {6, 5, 3}, true);
  builder.material("boxes", 0.5f, 0.0f);
  for (int i = 0; i < boxes; ++i) {
    const auto u = uniform4(stream_key(1, 0, 0), static_cast<std::uint64_t>(i));
    const Vec3 low(0.1f + 5.2f * u[0], 0.1f + 4.2f * u[1], 0.001f);
    builder.box(low, low + Vec3(0.05f + 0.4f * u[2], 0.05f + 0.4f * u[3], 0.1f + 1.2f * u[2] * u[3]), false);
  }
  builder.material("lamp", 0.0f, 100.0f);
  add_lamp(builder, lamp_triangles);
  return builder.take();
}

}  // namespace luxel::bench
