// SPDX-License-Identifier: Apache-2.0
// Processes against threads: the program itself, started by mpirun, on the same number of cores.
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <unistd.h>

#include "bench/sections.h"
#include "bench/timing.h"
#include "showpiece/write_obj.h"

namespace luxel::bench {
namespace {

namespace fs = std::filesystem;

constexpr int repetitions = 3;

// Seconds of the stage "light" of a bake of room.obj in that folder; below 0 where it failed.
double light_seconds(const fs::path& folder, const std::string& launcher, int threads, const char* error) {
  const auto line = fmt::format(
      "cd '{}' && {} '{}' bake room.obj --max-edge 0 --error {} --threads {} -o a.vtkhdf --report a.json "
      "--quiet "
      "> /dev/null",
      folder.string(), launcher, LUXEL_PROGRAM, error, threads);
  if (std::system(line.c_str()) != 0) return -1.0;
  for (const auto& stage : Json::parse(std::ifstream(folder / "a.json"))["stages"])
    if (stage["name"] == "light") return stage["seconds"];
  return -1.0;
}

}  // namespace

Json processes_against_threads(const Settings& settings) {
  const auto folder = fs::temp_directory_path() / fmt::format("luxel-bench-ranks-{}", getpid());
  fs::create_directories(folder);
  showpiece::write_reading_room(folder / "room.obj", 1);
  const auto* const error = settings.small ? "10%" : "2%";
  fmt::print("\nProcesses against threads: the reading room to {}, seconds of the light\n", error);
  fmt::print("{:>6} {:>9} {:>9} {:>16}\n", "cores", "threads", "ranks", "ranks / threads");
  auto table = Json::array();
  for (const int cores : {1, 2}) {
    const auto mpirun = fmt::format(
        "env OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun --oversubscribe --bind-to none "
        "-n {}",
        cores);
    std::vector<double> threads, ranks, ratio;
    for (int i = 0; i < repetitions; ++i) {  // in turn: a noisy machine disturbs both alike
      threads.push_back(light_seconds(folder, "", cores, error));
      ranks.push_back(light_seconds(folder, mpirun, 1, error));
      ratio.push_back(ranks.back() / threads.back());
    }
    if (median(ranks) < 0.0) {
      fmt::print("mpirun does not run here\n");
      break;
    }
    fmt::print("{:>6} {:>9.2f} {:>9.2f} {:>16.2f}\n", cores, median(threads), median(ranks), median(ratio));
    table.push_back({{"cores", cores},
                     {"threads_s", median(threads)},
                     {"ranks_s", median(ranks)},
                     {"ranks_over_threads", median(ratio)}});
  }
  std::error_code ignored;
  fs::remove_all(folder, ignored);
  return table;
}

}  // namespace luxel::bench
