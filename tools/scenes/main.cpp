// SPDX-License-Identifier: Apache-2.0
// luxel-scenes NAME FILE: writes one of the scenes that the gallery, the demo and the benchmarks use, one of
// our own luminaires, or our own year of weather.

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "luxel/core/output_file.h"

#include "scenes/luminaires/luminaires.h"
#include "scenes/scene_list.h"
#include "scenes/weather/temperate_year.h"
#include "scenes/write_scene.h"

namespace {

using luxel::scenes::luminaire_list;
using luxel::scenes::scene_list;

constexpr auto usage =
    "usage: luxel-scenes NAME FILE.obj|FILE.glb [--detail N]\n"
    "       luxel-scenes LUMINAIRE FILE.ies|FILE.ldt\n"
    "       luxel-scenes temperate-year FILE.wea\n"
    "       luxel-scenes --list\n"
    "Writes a scene: metres, Y up, the same bytes on every run. An OBJ has its MTL beside it; good cameras "
    "and\n"
    "a suitable --sky stand in its first lines. A GLB has the cameras, the sun and the spots too.\n"
    "  --detail N   cut every triangle in N x N of the same shape, 1 to 32 (default 1)\n";

enum ExitCode { fine = 0, failed = 1, misused = 2 };

struct Order {
  std::string name;
  std::filesystem::path path;
  int detail = 1;
};

bool is_luminaire_name(const std::string& name) {
  return std::any_of(luminaire_list().begin(), luminaire_list().end(),
                     [&](const auto& luminaire) { return luminaire.name == name; });
}

constexpr std::string_view weather_name = "temperate-year";

// The extensions of its files.
std::span<const char* const> endings_of(const std::string& name) {
  static constexpr const char* of_scenes[] = {".obj", ".glb"};
  static constexpr const char* of_luminaires[] = {".ies", ".ldt"};
  static constexpr const char* of_weather[] = {".wea"};
  if (name == weather_name) return of_weather;
  if (is_luminaire_name(name)) return of_luminaires;
  return of_scenes;
}

// What the command line orders; otherwise `wrong` is the reason.
std::optional<Order> order_of(std::span<char*> words, std::string& wrong) {
  auto order = Order{};
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto word = std::string_view(words[i]);
    if (word == "--detail" && i + 1 < words.size()) {
      const auto number = std::string_view(words[++i]);
      const auto [end, fault] = std::from_chars(number.data(), number.data() + number.size(), order.detail);
      if (fault != std::errc() || end != number.data() + number.size() || order.detail < 1 ||
          order.detail > 32)
        wrong = fmt::format("--detail: expected a whole number from 1 to 32, found '{}'", number);
    } else if (word.starts_with("-")) {
      wrong = fmt::format("unknown option '{}'", word);
    } else if (order.name.empty()) {
      order.name = word;
    } else if (order.path.empty()) {
      order.path = word;
    } else {
      wrong = fmt::format("expected a name and a file, found also '{}'", word);
    }
  }
  const auto named = [&](const auto& thing) { return thing.name == order.name; };
  const auto known = order.name == weather_name || is_luminaire_name(order.name) ||
                     std::any_of(scene_list().begin(), scene_list().end(), named);
  if (wrong.empty() && order.path.empty()) wrong = "expected the name of a scene and a file to write";
  if (wrong.empty() && !known)
    wrong = fmt::format("no scene is named '{}'; luxel-scenes --list prints the names", order.name);
  const auto endings = endings_of(order.name);
  if (wrong.empty() && std::find(endings.begin(), endings.end(), order.path.extension()) == endings.end())
    wrong = fmt::format("expected a file that ends in {}, found '{}'", fmt::join(endings, " or "),
                        order.path.string());
  if (!wrong.empty()) return {};
  return order;
}

void print_list() {
  for (const auto& scene : scene_list()) fmt::print("{:<14} {}\n", scene.name, scene.about);
  for (const auto& luminaire : luminaire_list()) fmt::print("{:<14} {}\n", luminaire.name, luminaire.about);
  fmt::print("{:<14} {}\n", weather_name, "weather of a year at 50 degrees north, for daylight");
}

}  // namespace

int main(int count, char** words) {
  const auto arguments = std::span<char*>(words + std::min(count, 1), words + count);
  const auto only = arguments.size() == 1 ? std::string_view(arguments[0]) : std::string_view();
  if (only == "--list") {
    print_list();
    return fine;
  }
  if (only == "-h" || only == "--help") {
    fmt::print("{}", usage);
    print_list();
    return fine;
  }
  auto wrong = std::string{};
  const auto order = order_of(arguments, wrong);
  if (!order) {
    fmt::print(stderr, "luxel-scenes: {}\n{}", wrong, usage);
    return misused;
  }
  try {
    if (order->name == weather_name)
      luxel::write_file(order->path, luxel::scenes::temperate_year());
    else if (is_luminaire_name(order->name))
      luxel::write_file(order->path,
                        luxel::scenes::luminaire_file(order->name, order->path.extension().string()));
    else
      luxel::scenes::write_scene(order->path, luxel::scenes::make_scene(order->name, order->detail));
  } catch (const std::exception& error) {
    fmt::print(stderr, "luxel-scenes: {}\n", error.what());
    return failed;
  }
  return fine;
}
