// SPDX-License-Identifier: Apache-2.0
// luxel-showpiece [--detail N] out/showpiece.obj: writes a furnished evening room as OBJ and MTL.

#include <algorithm>
#include <charconv>
#include <exception>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "showpiece/write_obj.h"

namespace {

constexpr auto usage =
    "usage: luxel-showpiece [--detail N] [-o] FILE.obj\n"
    "Writes a reading room in the evening as FILE.obj and FILE.mtl: metres, Y up, the same bytes on every "
    "run.\n"
    "Good cameras stand in the first lines of the file.\n"
    "  --detail N   every triangle cut in N x N of the same shape, 1 to 32 (1): 39,884 triangles at 1, "
    "358,956 "
    "at 3,\n"
    "               1,435,824 at 6\n";

enum ExitCode { fine = 0, failed = 1, misused = 2 };

struct Order {
  std::filesystem::path path;
  int detail = 1;
};

// What the command line asks for, if it is right.
std::optional<Order> order_of(std::span<char*> words) {
  auto order = Order{};
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto word = std::string_view(words[i]);
    if (word == "--detail" && i + 1 < words.size()) {
      const auto number = std::string_view(words[++i]);
      const auto [end, fault] = std::from_chars(number.data(), number.data() + number.size(), order.detail);
      if (fault != std::errc() || end != number.data() + number.size()) return {};
    } else if (word == "-o" && i + 1 < words.size()) {
      continue;
    } else if (order.path.empty()) {
      order.path = word;
    } else {
      return {};
    }
  }
  if (order.path.extension() != ".obj" || order.detail < 1 || order.detail > 32) return {};
  return order;
}

}  // namespace

int main(int count, char** words) {
  if (count == 2 && (std::string(words[1]) == "-h" || std::string(words[1]) == "--help")) {
    fmt::print("{}", usage);
    return fine;
  }
  const auto order = order_of({words + 1, words + std::max(count, 1)});
  if (!order) {
    fmt::print(stderr, "{}", usage);
    return misused;
  }
  try {
    luxel::showpiece::write_reading_room(order->path, order->detail);
  } catch (const std::exception& error) {
    fmt::print(stderr, "luxel-showpiece: {}\n", error.what());
    return failed;
  }
  return fine;
}
