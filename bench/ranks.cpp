// SPDX-License-Identifier: Apache-2.0
// Processes against threads: the program itself, started by mpirun, on the same number of cores. Also
// measures the data to which the model of docs/cluster.md is fitted.
#include <algorithm>
#include <cmath>
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

// Cost model of a solve, fitted to one and two ranks of one thread each.
struct Model {
  double ray = 0.0;        // s of a thread; shared by ranks
  double patch = 0.0;      // s of a thread; every rank does it
  double imbalance = 0.0;  // share of the rays' time that a rank waits
  double bytes = 0.0;      // exchanged, a patch and round
};

constexpr double memory_speed = 5e9;    // bytes/s between ranks of one machine
constexpr double network_speed = 10e9;  // bytes/s into a node: 100 Gbit/s, less what it costs

// From the fastest runs, since other work of a machine only makes them slower.
Model fitted(const Run& one, double light_of_two, const Run& two) {
  Model m;
  m.patch = std::max(0.0, 2.0 * (light_of_two - two.waited - one.light / 2.0) / two.patches);
  m.ray = (one.light - m.patch * one.patches) / one.rays;
  m.imbalance = std::max(0.0, (two.waited - two.bytes / memory_speed) / (m.ray * two.rays / 2.0));
  m.bytes = 2.0 * two.bytes / (two.patches * two.rounds);  // half of the rows are local
  return m;
}

// Seconds of the light of 10^7 patches, on ranks of 64 threads each, where the requested error takes `finer`
// times the rays of the case; and their parts for rays, for work of every rank, and for exchange.
void predict(const Model& m, const Run& run, double finer) {
  constexpr double patches = 1e7;
  constexpr double threads = 64.0;
  const auto rounds = run.rounds + std::log2(finer);
  for (const double ranks : {1.0, 10.0, 100.0, 1000.0}) {
    const auto smoothing = ranks > 1.0 ? 1.0 + m.imbalance : 1.0;
    const auto rays = smoothing * m.ray * finer * run.rays / run.patches * patches / (threads * ranks);
    const auto alike = m.patch * patches / threads * rounds / run.rounds;
    const auto exchange = m.bytes * patches * rounds / network_speed * (1.0 - 1.0 / ranks);
    fmt::print("{:>8.0f} {:>8.0f} {:>10.1f} {:>10.1f} {:>10.1f} {:>10.1f}\n", finer, ranks,
               rays + alike + exchange, rays, alike, exchange);
  }
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
    Run one;
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
      last.light = std::min(*std::min_element(ranks.begin(), ranks.end()),
                            cores == 1 ? *std::min_element(threads.begin(), threads.end()) : 1e30);
      if (cores == 1) {
        one = last;
        continue;
      }
      const auto m = fitted(one, last.light, last);
      fmt::print(
          "model: {:.2f} us a ray, {:.1f} us a patch in every rank, {:.0f} bytes a patch and round, waiting "
          "{:.0f} % of the rays' time\n",
          1e6 * m.ray, 1e6 * m.patch, m.bytes, 100.0 * m.imbalance);
      fmt::print(
          "10^7 patches, 64 threads a rank, predicted seconds\n{:>8} {:>8} {:>10} {:>10} {:>10} {:>10}\n",
          "rays x", "ranks", "light", "rays", "alike", "exchange");
      for (const double finer : {1.0, 100.0}) predict(m, last, finer);
      table.back()["model"] = {
          {"ray_s", m.ray}, {"patch_s", m.patch}, {"imbalance", m.imbalance}, {"bytes", m.bytes}};
    }
    std::error_code ignored;
    fs::remove_all(folder, ignored);
  }
  return table;
}

}  // namespace luxel::bench
