// SPDX-License-Identifier: Apache-2.0
// luxel-showpiece out/showpiece.obj: writes a furnished evening room as OBJ and MTL.

#include <exception>
#include <filesystem>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "showpiece/write_obj.h"

namespace {

constexpr auto usage =
    "usage: luxel-showpiece [-o] FILE.obj\n"
    "Writes a reading room in the evening as FILE.obj and FILE.mtl: metres, Y up, the same bytes on every "
    "run.\n"
    "Good cameras stand in the first lines of the file.\n";

enum ExitCode { fine = 0, failed = 1, misused = 2 };

// The one file named on the command line, if the command line is right.
std::optional<std::filesystem::path> named_file(int count, char** words) {
  const auto has_option = count == 3 && std::string(words[1]) == "-o";
  if (!has_option && count != 2) return {};
  const auto path = std::filesystem::path(words[count - 1]);
  if (path.extension() != ".obj") return {};
  return path;
}

}  // namespace

int main(int count, char** words) {
  if (count == 2 && (std::string(words[1]) == "-h" || std::string(words[1]) == "--help")) {
    fmt::print("{}", usage);
    return fine;
  }
  const auto path = named_file(count, words);
  if (!path) {
    fmt::print(stderr, "{}", usage);
    return misused;
  }
  try {
    luxel::showpiece::write_reading_room(*path);
  } catch (const std::exception& error) {
    fmt::print(stderr, "luxel-showpiece: {}\n", error.what());
    return failed;
  }
  return fine;
}
