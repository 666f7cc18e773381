// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/desktop.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include "luxel/core/ending_of.h"
#include "luxel/runs/outputs.h"

namespace luxel {
namespace {

constexpr const char* opener = "xdg-open";  // freedesktop.org's, part of every Linux desktop

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

// The path of a program, as a shell finds it; empty where there is none.
std::string path_of(const std::string& program) {
  std::istringstream folders(variable("PATH"));
  for (std::string folder; std::getline(folders, folder, ':');) {
    const auto path = (folder.empty() ? "." : folder) + "/" + program;
    if (::access(path.c_str(), X_OK) == 0) return path;
  }
  return {};
}

bool is_mesh(const std::string& file) { return ending_of(file) == ".glb" || ending_of(file) == ".ply"; }

// Starts a program in a session of its own, without our streams. Its parent ends at once, so that it becomes
// a child of the system and is never waited for. Only functions that are safe after fork() are called there.
bool start_detached(const std::string& program, const std::string& argument) {
  char* const arguments[] = {const_cast<char*>(program.c_str()), const_cast<char*>(argument.c_str()),
                             nullptr};
  const auto child = ::fork();
  if (child < 0) return false;
  if (child == 0) {
    ::setsid();
    if (::fork() != 0) ::_exit(0);
    const int nothing = ::open("/dev/null", O_RDWR);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(nothing, stream);
    ::execv(program.c_str(), arguments);
    ::_exit(127);
  }
  int status = 0;
  return ::waitpid(child, &status, 0) == child;
}

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
  const auto program = path_of(opener);
  if (program.empty())
    return fail(
        fmt::format("the program {} is not installed (package xdg-utils); {} is written", opener, file));
  if (!start_detached(program, std::filesystem::absolute(file).string()))
    return fail(fmt::format("{} could not be started; {} is written", program, file));
}

}  // namespace luxel
