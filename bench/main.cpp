// SPDX-License-Identifier: Apache-2.0
// luxel-bench [OUT.json] [SECTION...]: how fast and how accurate. ./dev bench runs it.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "bench/sections.h"
#include "bench/timing.h"

namespace luxel::bench {
namespace {

struct Section {
  const char* word;
  const char* key;  // in the JSON file
  Json (*measure)(const Settings&);
};

constexpr Section sections[] = {
    {"limit", "solve_over_embree", against_embree},
    {"gather", "sampled_over_embree", sampled_against_embree},
    {"polygons", "time_against_polygons", against_polygons},
    {"lamps", "time_against_lamps", against_lamps},
    {"facets", "shadow_rays_to_facets", against_facets},
    {"luminaires", "luminaires_against_square_lamps", luminaires_against_lamps},
    {"threads", "thread_scaling", against_threads},
    {"error", "error_against_time", error_against_time},
    {"variance", "variance_reduction", variance_reduction},
    {"coverage", "stated_against_true", stated_against_true},
    {"patches", "cost_per_patch", cost_per_patch},
    {"order", "ray_order", ray_order},
    {"light", "time_to_first_light", time_to_first_light},
    {"reconstruction", "reconstruction", reconstruction},
    {"load", "load_to_files", load_to_files},
    {"mesh", "error_against_patches", error_against_patches},
    {"relight", "relighting", changed_lamps_and_colours},
    {"view", "frames_while_solving", frames_while_solving},
    {"daylight", "hours_over_limits", hours_against_limits},
    {"ranks", "ranks_against_threads", processes_against_threads},
};

constexpr auto usage =
    "usage: luxel-bench [OUT.json] [--small] [SECTION...]\n"
    "Prints tables and keeps them in OUT.json; with sections named, what OUT.json has of others stays.\n"
    "Converged references are kept in the folder references beside OUT.json; remove it to have them anew.\n"
    "  --small   tiny sizes, to see that it works: the numbers mean nothing\n"
    "sections:";

struct Order {
  std::string file;
  std::vector<std::string> words;
  Settings settings;
  bool wrong = false;
};

Order order_of(const std::vector<std::string>& arguments) {
  Order order;
  for (const auto& word : arguments) {
    const auto is_section =
        std::any_of(std::begin(sections), std::end(sections), [&](const auto& s) { return s.word == word; });
    if (word == "--small")
      order.settings.small = true;
    else if (is_section)
      order.words.push_back(word);
    else if (order.file.empty() && word.ends_with(".json"))
      order.file = word;
    else
      order.wrong = true;
  }
  if (!order.file.empty())
    order.settings.references = std::filesystem::path(order.file).parent_path() / "references";
  return order;
}

Json kept_before(const Order& order) {
  std::ifstream file(order.file);
  return order.words.empty() || !file ? Json::object() : Json::parse(file);
}

void keep(const std::string& name, const Json& result) {
  std::ofstream file(name);
  file << result.dump(2) << "\n";
  if (!file.flush()) throw std::runtime_error("cannot write " + name);
}

void measure(const Order& order) {
  auto result = kept_before(order);
  result["cores"] = std::thread::hardware_concurrency();
  for (const auto& [word, key, section] : sections) {
    const auto is_wanted =
        order.words.empty() || std::find(order.words.begin(), order.words.end(), word) != order.words.end();
    if (!is_wanted) continue;
    const auto time = seconds([&, key = key, section = section] { result[key] = section(order.settings); });
    fmt::print("({:.0f} s)\n", time);
    if (!order.file.empty()) keep(order.file, result);
  }
  if (!order.file.empty()) fmt::print("\nkept in {}\n", order.file);
}

}  // namespace
}  // namespace luxel::bench

int main(int count, char** words) {
  using namespace luxel::bench;
  std::setvbuf(stdout, nullptr, _IOLBF, 0);  // rows appear as they are measured, in a pipe too
  const auto order = order_of({words + 1, words + std::max(count, 1)});
  if (order.wrong) {
    fmt::print(stderr, "{}", usage);
    for (const auto& section : sections) fmt::print(stderr, " {}", section.word);
    fmt::print(stderr, "\n");
    return 2;
  }
  try {
    measure(order);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "luxel-bench: {}\n", error.what());
    return 1;
  }
}
