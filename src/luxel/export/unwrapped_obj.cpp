// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/unwrapped_obj.h"

#include <algorithm>

#include <fmt/format.h>

namespace luxel {
namespace {

// A name as one word, as OBJ has them.
std::string one_word(std::string name) {
  for (auto& c : name)
    if (static_cast<unsigned char>(c) <= ' ') c = '_';
  return name.empty() ? "unnamed" : name;
}

}  // namespace

UnwrappedObj::UnwrappedObj(const Scene& scene, double metres_per_unit)
    : scene_(scene),
      metres_per_unit_(metres_per_unit),
      text_("# vt: coordinates of a lightmap; page n + 1 lies n to the right\n") {}

std::vector<Vec3d> UnwrappedObj::positions_of(const RoundTripPart& part,
                                              const RoundTripSurface& surface) const {
  std::vector<Vec3d> of_file(part.vertices, Vec3d(0.0));
  for (std::size_t i = 0; i < part.triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      of_file[part.corners[i][k]] =
          (scene_.origin + Vec3d(scene_.positions[scene_.triangles[part.triangles[i]][k]])) /
          metres_per_unit_;
  std::vector<Vec3d> positions;
  for (const auto v : surface.own) positions.push_back(of_file[v]);
  for (const auto& added : surface.added) {
    Vec3d sum(0.0);
    for (std::size_t i = 0; i < 3; ++i) sum += added.weights[static_cast<int>(i)] * of_file[added.of[i]];
    positions.push_back(sum);
  }
  return positions;
}

void UnwrappedObj::add(const RoundTripPart& part, const RoundTripSurface& surface) {
  const auto first = part.triangles.front();
  const auto& name = scene_.objects.empty() ? scene_.groups[scene_.triangle_group[first]]
                                            : scene_.objects[scene_.triangle_object[first]];
  text_ +=
      fmt::format("o {}{}\nusemtl {}\n", one_word(name), surface.back ? "_back" : "",
                  one_word(scene_.materials[static_cast<std::size_t>(scene_.triangle_material[first])].name));
  const auto positions = positions_of(part, surface);
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const auto& p = positions[v];
    const auto& uv = surface.uv[v];
    text_ += fmt::format("v {:.9g} {:.9g} {:.9g}\nvt {:.9g} {:.9g}\n", p.x, p.y, p.z,
                         static_cast<float>(surface.page) + uv.x, 1.0f - uv.y);
  }
  for (auto triangle : surface.triangles) {
    if (part.mirrored) std::swap(triangle[1], triangle[2]);
    const auto at = [&](std::size_t k) { return vertices_ + triangle[k] + 1; };
    text_ += fmt::format("f {0}/{0} {1}/{1} {2}/{2}\n", at(0), at(1), at(2));
  }
  vertices_ += positions.size();
}

}  // namespace luxel
