// SPDX-License-Identifier: Apache-2.0
#include "bench/rooms.h"

#include "luxel/core/address.h"

#include "bench/mesher.h"

namespace luxel::bench {
namespace {

void add_lamp(Mesher& mesher, int triangles) {
  int side = 1;
  while (2 * side * side < triangles) side *= 2;
  const float step = 1.0f / static_cast<float>(side);
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const float x = 2.5f + step * static_cast<float>(i);
      const float y = 2.0f + step * static_cast<float>(j);
      const float z = 2.9f;
      mesher.quad({x, y, z}, {x, y + step, z}, {x + step, y + step, z}, {x + step, y, z});  // faces down
    }
}

}  // namespace

Scene furnished_room(int boxes, int lamp_triangles) {
  Mesher mesher;
  mesher.material("walls", Vec3(0.7f));
  mesher.box({0, 0, 0}, {6, 5, 3}, true);
  mesher.material("boxes", Vec3(0.5f));
  for (int i = 0; i < boxes; ++i) {
    const auto u = uniform4(stream_key(1, 0, 0), static_cast<std::uint64_t>(i));
    const Vec3 low(0.1f + 5.2f * u[0], 0.1f + 4.2f * u[1], 0.001f);
    mesher.box(low, low + Vec3(0.05f + 0.4f * u[2], 0.05f + 0.4f * u[3], 0.1f + 1.2f * u[2] * u[3]));
  }
  mesher.material("lamp", Vec3(0.0f), Vec3(100.0f));
  add_lamp(mesher, lamp_triangles);
  return mesher.take();
}

}  // namespace luxel::bench
