// SPDX-License-Identifier: Apache-2.0
#include "showpiece/write_obj.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "luxel/core/output_file.h"

namespace luxel::showpiece {
namespace {

const Pigment& pigment_of(Paint paint) { return palette()[static_cast<std::size_t>(paint)]; }

std::string numbers(const Vec3d& v, const char* between) {
  return fmt::format("{:g}{}{:g}{}{:g}", v.x, between, v.y, between, v.z);
}

void add_header(std::string& text, std::span<const View> views, const std::string& mtl_name) {
  text +=
      "# A reading room in the evening, for showing light that comes and goes between surfaces.\n"
      "# Metres, Y up, floor at y = 0; written by luxel-showpiece.\n";
  for (const auto& view : views) {
    text += fmt::format("# camera, {}: --eye {} --target {} --fov {:g}\n", view.name, numbers(view.eye, ","),
                        numbers(view.target, ","), view.vertical_fov);
  }
  text += fmt::format("mtllib {}\n", mtl_name);
}

void add_object(std::string& text, const Object& object, std::size_t first_point) {
  auto out = std::back_inserter(text);
  fmt::format_to(out, "\no {0}\ng {0}\n", object.name);
  for (const auto& p : object.mesh.points) fmt::format_to(out, "v {:.6f} {:.6f} {:.6f}\n", p.x, p.y, p.z);
  auto triangles = object.mesh.triangles;
  std::stable_sort(triangles.begin(), triangles.end(),
                   [](const Triangle& a, const Triangle& b) { return a.paint < b.paint; });
  auto last = Paint::count;
  for (const auto& [corners, paint] : triangles) {
    if (paint != last) fmt::format_to(out, "usemtl {}\n", pigment_of(paint).name);
    last = paint;
    const auto& [a, b, c] = corners;
    fmt::format_to(out, "f {} {} {}\n", first_point + a, first_point + b, first_point + c);
  }
}

}  // namespace

std::string obj_text(std::span<const Object> objects, std::span<const View> views,
                     const std::string& mtl_name) {
  auto text = std::string{};
  add_header(text, views, mtl_name);
  auto next_point = std::size_t{1};  // OBJ counts from one, through the whole file
  for (const auto& object : objects) {
    add_object(text, object, next_point);
    next_point += object.mesh.points.size();
  }
  return text;
}

std::string mtl_text() {
  auto text = std::string{
      "# Kd: reflectance of the linear sRGB bands, 0 to 1. Ke: radiance of the front side, W/(m² sr) a "
      "band.\n"};
  for (const auto& pigment : palette()) {
    text += fmt::format("\nnewmtl {}\nKd {}\n", pigment.name, numbers(pigment.reflectance, " "));
    if (shines(pigment)) text += fmt::format("Ke {}\n", numbers(pigment.radiance, " "));
  }
  return text;
}

void write_reading_room(const std::filesystem::path& path, int detail) {
  auto mtl = path;
  mtl.replace_extension(".mtl");
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path());
  write_file(mtl, mtl_text());
  write_file(path, obj_text(reading_room(detail), views(), mtl.filename().string()));
}

}  // namespace luxel::showpiece
