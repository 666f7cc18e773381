// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/desktop.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>

#include "luxel/core/detached_process.h"
#include "luxel/core/ending_of.h"
#include "luxel/runs/outputs.h"

namespace luxel {
namespace {

constexpr const char* opener = "xdg-open";  // freedesktop.org's, part of every Linux desktop

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

bool is_mesh(const std::string& file) { return ending_of(file) == ".glb" || ending_of(file) == ".ply"; }

}  // namespace

std::string file_to_open(const std::vector<std::string>& files) {
  for (const auto is_of_kind : {is_picture, is_page, is_mesh})
    if (const auto file = std::find_if(files.begin(), files.end(), is_of_kind); file != files.end())
      return *file;
  return {};
}

void open_one_of(const std::vector<std::string>& files, Console& console) {
  const auto file = file_to_open(files);
  const auto fail = [&](const std::string& why) { warn(console.log(), "--open: " + why); };
  if (file.empty()) return fail("there is no picture, page or mesh among the written files");
  if (variable("DISPLAY").empty() && variable("WAYLAND_DISPLAY").empty())
    return fail(fmt::format("there is no desktop here (DISPLAY is not set); {} is written", file));
  const auto program = path_of_program(opener);
  if (program.empty())
    return fail(
        fmt::format("the program {} is not installed (package xdg-utils); {} is written", opener, file));
  if (!start_detached(program, std::filesystem::absolute(file).string()))
    return fail(fmt::format("{} could not be started; {} is written", program, file));
}

}  // namespace luxel
