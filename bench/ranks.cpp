// SPDX-License-Identifier: Apache-2.0
// Processes against threads: the program itself, started by mpirun, on the same number of cores.
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <unistd.h>

#include "bench/sections.h"
#include "bench/timing.h"
#include "scenes/scene_list.h"
#include "scenes/write_scene.h"

namespace luxel::bench {
namespace {

namespace fs = std::filesystem;

constexpr int repetitions = 3;

struct Run {
  double light = -1.0;  // s, of that stage; below 0 where it failed
  double waited = 0.0;  // s, of the first rank
  double bytes = 0.0;   // that it received
  double rays = 0.0;
  double patches = 0.0;
  double rounds = 0.0;
};

// A bake of scene.obj in that folder.
Run bake(const fs::path& folder, const std::string& launcher, int threads, const std::string& options) {
  const auto line = fmt::format(
      "cd '{}' && {} '{}' bake scene.obj {} --threads {} -o a.vtkhdf --json-file a.json --quiet > /dev/null",
      folder.string(), launcher, LUXEL_PROGRAM, options, threads);
  if (std::system(line.c_str()) != 0) return {};
  const auto report = Json::parse(std::ifstream(folder / "a.json"));
  const auto& solve = report["solve"];
  Run run;
  for (const auto& stage : report["stages"])
    if (stage["name"] == "light") run.light = stage["seconds"];
  if (solve.contains("ranks")) {
    run.waited = solve["ranks"]["waited_seconds"];
    run.bytes = solve["ranks"]["received_bytes"];
  }
  run.rays = report["solution"]["rays"];
  run.patches = report["solution"]["patches"];
  run.rounds = static_cast<double>(solve["rounds"].size());
  return run;
}

struct Case {
  const char* name;
  void (*write)(const fs::path&);
  const char* options;
  const char* small_options;
};
void write_cornell_box(const fs::path& file) {
  fs::copy_file(fs::path(LUXEL_SCENES) / "cornell-box.obj", file);
  fs::copy_file(fs::path(LUXEL_SCENES) / "cornell-box.mtl", file.parent_path() / "cornell-box.mtl");
}
const Case cases[] = {
    {"reading room, 2 %",
     [](const fs::path& file) { scenes::write_scene(file, scenes::make_scene("reading-room")); },
     "--max-edge 0 --error-measure power --error 2%", "--max-edge 0 --error-measure power --error 20%"},
    {"Cornell box, 0.3 %", write_cornell_box, "--max-edge 0.02 --error-measure power --error 0.3%",
     "--max-edge 0.1 --error-measure power --error 10%"},
    {"Cornell box, 1 %", write_cornell_box, "--max-edge 0.008 --error-measure power --error 1%",
     "--max-edge 0.1 --error-measure power --error 10%"},
};

}  // namespace

Json processes_against_threads(const Settings& settings) {
  fmt::print("\nProcesses against threads, seconds of the light\n");
  fmt::print("{:20} {:>6} {:>9} {:>9} {:>16} {:>9} {:>14} {:>8}\n", "", "cores", "threads", "ranks",
             "ranks / threads", "waited", "received, MB", "patches");
  auto table = Json::array();
  for (const auto& c : cases) {
    const auto folder = fs::temp_directory_path() / fmt::format("luxel-bench-ranks-{}", getpid());
    fs::create_directories(folder);
    c.write(folder / "scene.obj");
    const std::string options = settings.small ? c.small_options : c.options;
    for (const int cores : {1, 2}) {
      const auto mpirun = fmt::format(
          "env OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun --oversubscribe --bind-to "
          "none "
          "-n {}",
          cores);
      std::vector<double> threads, ranks, ratio;
      Run last;
      for (int i = 0; i < repetitions; ++i) {  // in turn: a noisy machine disturbs both alike
        threads.push_back(bake(folder, "", cores, options).light);
        last = bake(folder, mpirun, 1, options);
        ranks.push_back(last.light);
        ratio.push_back(ranks.back() / threads.back());
      }
      if (median(ranks) < 0.0) {
        fmt::print("mpirun does not run here\n");
        break;
      }
      fmt::print("{:20} {:>6} {:>9.2f} {:>9.2f} {:>16.2f} {:>9.2f} {:>14.1f} {:>8}\n", c.name, cores,
                 median(threads), median(ranks), median(ratio), last.waited, 1e-6 * last.bytes, last.patches);
      table.push_back({{"scene", c.name},
                       {"cores", cores},
                       {"threads_s", median(threads)},
                       {"ranks_s", median(ranks)},
                       {"ranks_over_threads", median(ratio)},
                       {"waited_s", last.waited},
                       {"received_bytes", last.bytes},
                       {"rays", last.rays},
                       {"rounds", last.rounds},
                       {"patches", last.patches}});
    }
    std::error_code ignored;
    fs::remove_all(folder, ignored);
  }
  return table;
}

}  // namespace luxel::bench
