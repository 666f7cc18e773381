// SPDX-License-Identifier: Apache-2.0
// From an OBJ file to patches that can be lit, and from light to files: the cost of a large mesh before and
// after the light, step by step.
#include <cmath>
#include <filesystem>
#include <functional>
#include <optional>

#include <fmt/format.h>
#include <unistd.h>

#include "luxel/classical/stochastic_jacobi.h"
#include "luxel/export/export_mesh.h"
#include "luxel/import/load_scene.h"
#include "luxel/lamps/lamp_check.h"
#include "luxel/patch/make_patches.h"
#include "luxel/patch/patch_tree.h"
#include "luxel/solution/solution_file.h"

#include "bench/sections.h"
#include "bench/timing.h"
#include "scenes/scene_list.h"
#include "scenes/write_scene.h"

namespace luxel::bench {
namespace {

namespace fs = std::filesystem;

constexpr int repetitions = 3;

// A folder that is removed with this object.
class Scratch {
 public:
  Scratch() : path_(fs::temp_directory_path() / fmt::format("luxel-bench-{}", getpid())) {
    fs::create_directories(path_);
  }
  ~Scratch() {
    std::error_code error;
    fs::remove_all(path_, error);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  fs::path operator/(const char* name) const { return path_ / name; }

 private:
  fs::path path_;
};

struct Steps {
  std::size_t triangles = 0;
  double megabytes = 0.0;  // of the OBJ file
  std::vector<std::pair<const char*, double>> seconds;
};

// Median over repetitions; the first answer is kept.
template <typename Make>
auto timed(Steps& steps, const char* name, Make make) {
  std::vector<double> times;
  std::optional<decltype(make())> first;
  for (int i = 0; i < repetitions; ++i)
    times.push_back(cost([&] {
                      auto made = make();
                      if (!first) first.emplace(std::move(made));
                    }).cpu);
  steps.seconds.emplace_back(name, median(times));
  return std::move(*first);
}

void timed_write(Steps& steps, const char* name, const std::function<void()>& write) {
  timed(steps, name, [&] { return write(), 0; });
}

Steps measure(int detail, const Scratch& scratch) {
  const auto file = scratch / "room.obj";
  scenes::write_scene(file, scenes::make_scene("reading-room", detail));
  const Context one(1);
  Steps steps;
  steps.megabytes = 1e-6 * static_cast<double>(fs::file_size(file));
  const auto scene = timed(steps, "load", [&] { return load_scene(file); });
  steps.triangles = scene.triangles.size();
  const auto patches =
      timed(steps, "patches", [&] { return make_patches(scene, {.max_edge = no_max_edge}); });
  const auto tracer = timed(steps, "hierarchy", [&] { return Tracer(patches, one); });
  timed(steps, "tree", [&] { return make_patch_tree(patches, one); });
  timed(steps, "lamps", [&] { return view_from_lamps(patches, tracer, one); });
  Solution solution;
  solve_stochastic_jacobi(patches, tracer, solution, glance(patches), one);
  const auto light = timed(steps, "surface", [&] { return make_smooth_light(patches, solution); });
  timed_write(steps, "vtkhdf", [&] { write_solution(scratch / "room.vtkhdf", patches, solution); });
  timed_write(steps, "glb", [&] {
    export_glb(scratch / "room.glb", patches, solution, light, {0.0f, 1.0f, 0.0f});
  });
  timed_write(steps, "ply", [&] { export_ply(scratch / "room.ply", patches, solution, light); });
  return steps;
}

double n_log_n(const Steps& steps) {
  const auto n = static_cast<double>(steps.triangles);
  return n * std::log(n);
}

}  // namespace

Json load_to_files(const Settings& settings) {
  fmt::print(
      "\nload: the reading room from OBJ to files without a solve, seconds on one thread; growth: of the "
      "time "
      "over n log n (1 is n log n)\n");
  const Scratch scratch;
  const auto small = measure(settings.small ? 1 : 2, scratch);
  const auto large = measure(settings.small ? 2 : 5, scratch);
  fmt::print("{:>10} {:>12} {:>12} {:>12}\n", "step", small.triangles, large.triangles, "growth");
  Json json = {{"triangles", large.triangles}, {"megabytes", large.megabytes}};
  for (std::size_t i = 0; i < large.seconds.size(); ++i) {
    const auto [name, seconds] = large.seconds[i];
    const auto growth = seconds / n_log_n(large) / (small.seconds[i].second / n_log_n(small));
    fmt::print("{:>10} {:>12.3f} {:>12.3f} {:>12.2f}\n", name, small.seconds[i].second, seconds, growth);
    json["steps"].push_back({{"step", name}, {"seconds", seconds}, {"growth_over_n_log_n", growth}});
  }
  const auto speed = large.megabytes / large.seconds.front().second;
  fmt::print("load reads {:.0f} MB/s ({:.1f} MB; at least 50 are asked)\n", speed, large.megabytes);
  json["load_MB_per_s"] = speed;
  return json;
}

}  // namespace luxel::bench
