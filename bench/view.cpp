// SPDX-License-Identifier: Apache-2.0
// Responsiveness of the window: the time of each frame, off screen, while the light is being solved.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/viewer/run_window.h"

#include "bench/scenes.h"
#include "bench/sections.h"

namespace luxel::bench {
namespace {

void write_obj(const Scene& scene, const std::filesystem::path& path) {
  auto library = path;
  library.replace_extension(".mtl");
  std::ofstream mtl(library), obj(path);
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    const auto& material = scene.materials[m];
    const auto radiance = material.emittance / pi;
    mtl << fmt::format("newmtl m{}\nKd {} {} {}\nKe {} {} {}\n", m, material.reflectance.r,
                       material.reflectance.g, material.reflectance.b, radiance.r, radiance.g, radiance.b);
  }
  obj << fmt::format("mtllib {}\n", library.filename().string());
  for (const auto& p : scene.positions) obj << fmt::format("v {} {} {}\n", p.x, p.y, p.z);
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    if (t == 0 || scene.triangle_material[t] != scene.triangle_material[t - 1])
      obj << fmt::format("usemtl m{}\n", static_cast<unsigned>(scene.triangle_material[t]));
    const auto& c = scene.triangles[t];
    obj << fmt::format("f {} {} {}\n", c[0] + 1, c[1] + 1, c[2] + 1);
  }
}

// The view turns for 600 frames as soon as there is a picture.
std::string look_around() {
  std::string script = "wait mesh\n";
  for (int i = 0; i < 20; ++i) script += "drag 400 400 600 380 right\ndrag 600 380 500 420 right\n";
  return script + "close\n";
}

double percentile(std::vector<double> values, double smoothing) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(smoothing * static_cast<double>(values.size() - 1))];
}

Json measure(const std::filesystem::path& folder, std::size_t triangles) {
  const auto path = folder / fmt::format("office-{}.obj", triangles);
  write_obj(office(triangles), path);
  WindowSettings settings{.file = path, .size = {1280, 800}, .off_screen = true};
  settings.eye = Vec3d(1.0, 1.6, 1.0);
  settings.target = Vec3d(11.0, 1.0, 8.0);
  settings.live = [](const std::filesystem::path&) {
    SessionSettings live;
    live.patches.max_edge = no_max_edge;
    live.light.sampled.error = 1e-4;  // not reached during the frames
    return live;
  };
  settings.script = parse_script("looking around", look_around());
  const auto report = run_window(settings);
  const auto& all = report.frame_seconds;
  const auto& solving = report.solving_frame_seconds;
  Json row = {{"triangles", triangles}, {"frames", all.size()}, {"frames_while_solving", solving.size()}};
  if (solving.empty()) return row;
  for (const auto& [word, smoothing] : {std::pair("median_ms", 0.5), std::pair("p95_ms", 0.95),
                                        std::pair("p99_ms", 0.99), std::pair("longest_ms", 1.0)})
    row[word] = 1e3 * percentile(solving, smoothing);
  row["longest_of_all_ms"] = 1e3 * percentile(all, 1.0);
  fmt::print("{:>10} {:>8} {:>10.1f} {:>8.1f} {:>8.1f} {:>9.1f}\n", triangles, solving.size(),
             row["median_ms"].get<double>(), row["p95_ms"].get<double>(), row["p99_ms"].get<double>(),
             row["longest_ms"].get<double>());
  return row;
}

}  // namespace

Json frames_while_solving(const Settings& settings) {
  const auto folder = std::filesystem::temp_directory_path() / "luxel-bench-view";
  std::filesystem::create_directories(folder);
  Json result = Json::array();
  try {
    const auto screen = open_off_screen({16, 16});
    fmt::print("{}, 1280 x 800\n", current_driver().name);
  } catch (const DeviceError& error) {
    fmt::print("left out: {}\n", error.what());
    return result;
  }
  fmt::print("{:>10} {:>8} {:>10} {:>8} {:>8} {:>9}\n", "triangles", "frames", "median ms", "95th", "99th",
             "longest");
  for (const std::size_t triangles : {10'000u, 100'000u, 1'000'000u})
    result.push_back(measure(folder, settings.small ? triangles / 10 : triangles));
  std::filesystem::remove_all(folder);
  return result;
}

}  // namespace luxel::bench
