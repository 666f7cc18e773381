// SPDX-License-Identifier: Apache-2.0
#include <iterator>
#include <string_view>

#include <fmt/format.h>

#include "scenes/write_scene.h"

namespace luxel::scenes {
namespace {

template <typename Vector>
std::string numbers(const Vector& v, std::string_view between) {
  return fmt::format("{:.6g}{}{:.6g}{}{:.6g}", v.x, between, v.y, between, v.z);
}

std::string header(const MadeScene& about, const std::string& mtl_name) {
  auto text = fmt::format("# {}. Metres, Y up, floor at y = 0; written by luxel-scenes.\n", about.title);
  if (!about.sky.empty()) text += fmt::format("# bake with --sky {}\n", about.sky);
  if (!about.lights.empty()) text += "# OBJ has no suns and spots: the .glb of this scene has them too.\n";
  for (const auto& view : about.views) {
    text += fmt::format("# camera, {}: --eye {} --target {} --fov {:g}\n", view.name, numbers(view.eye, ","),
                        numbers(view.target, ","), view.vertical_fov);
  }
  return text + fmt::format("mtllib {}\n", mtl_name);
}

}  // namespace

std::string obj_text(const Scene& scene, const MadeScene& about, const std::string& mtl_name) {
  auto text = header(about, mtl_name);
  auto out = std::back_inserter(text);
  // The points of an object stand before its triangles, which share them.
  auto next_point = std::uint32_t{0};
  for (std::size_t i = 0, group = 0; i < scene.triangles.size(); ++group) {
    auto end = i;
    auto last_point = next_point;
    while (end < scene.triangles.size() && scene.triangle_group[end] == group) {
      for (const auto corner : scene.triangles[end]) last_point = std::max(last_point, corner + 1);
      ++end;
    }
    fmt::format_to(out, "\no {0}\ng {0}\n", scene.groups[group]);
    for (; next_point < last_point; ++next_point) {
      const auto& p = scene.positions[next_point];
      fmt::format_to(out, "v {:.6f} {:.6f} {:.6f}\n", p.x, p.y, p.z);
    }
    for (const auto first = i; i < end; ++i) {
      const auto material = scene.triangle_material[i];
      if (i == first || material != scene.triangle_material[i - 1])
        fmt::format_to(out, "usemtl {}\n", scene.materials[static_cast<std::size_t>(material)].name);
      const auto& [a, b, c] = scene.triangles[i];
      fmt::format_to(out, "f {} {} {}\n", a + 1, b + 1, c + 1);
    }
  }
  return text;
}

std::string mtl_text(const Scene& scene) {
  auto text = std::string{
      "# Kd: reflectance of the linear sRGB bands, 0 to 1. Ke: radiance of the front side, W/(m² sr) per "
      "band.\n"};
  for (const auto& material : scene.materials) {
    text += fmt::format("\nnewmtl {}\nKd {}\n", material.name, numbers(material.reflectance, " "));
    if (material.is_lamp())
      text += fmt::format("Ke {}\n", numbers(Vec3d(material.emittance) / Vec3d(pi), " "));
  }
  return text;
}

}  // namespace luxel::scenes
