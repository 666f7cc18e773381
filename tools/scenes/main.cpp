// SPDX-License-Identifier: Apache-2.0
// luxel-scenes NAME FILE.obj|FILE.glb: writes one of the scenes that the gallery, the demo and the benchmarks
// use.

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

#include "scenes/scene_list.h"
#include "scenes/write_scene.h"

namespace {

using luxel::scenes::scene_list;

constexpr auto usage =
    "usage: luxel-scenes NAME FILE.obj|FILE.glb [--detail N]\n"
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
  const auto named = [&](const auto& scene) { return scene.name == order.name; };
  const auto known = std::any_of(scene_list().begin(), scene_list().end(), named);
  if (wrong.empty() && order.path.empty()) wrong = "expected the name of a scene and a file to write";
  if (wrong.empty() && !known)
    wrong = fmt::format("no scene is named '{}'; luxel-scenes --list prints the names", order.name);
  if (wrong.empty() && order.path.extension() != ".obj" && order.path.extension() != ".glb")
    wrong = fmt::format("expected a file that ends in .obj or .glb, found '{}'", order.path.string());
  if (!wrong.empty()) return {};
  return order;
}

void print_list() {
  for (const auto& scene : scene_list()) fmt::print("{:<14} {}\n", scene.name, scene.about);
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
    luxel::scenes::write_scene(order->path, luxel::scenes::make_scene(order->name, order->detail));
  } catch (const std::exception& error) {
    fmt::print(stderr, "luxel-scenes: {}\n", error.what());
    return failed;
  }
  return fine;
}
