// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/detached_process.h"

#include <cstdlib>
#include <sstream>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace luxel {

std::string path_of_program(const std::string& name) {
  const char* const path_variable = std::getenv("PATH");
  std::istringstream folders(path_variable ? path_variable : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const auto path = (folder.empty() ? "." : folder) + "/" + name;
    if (::access(path.c_str(), X_OK) == 0) return path;
  }
  return {};
}

// Its parent ends at once, so that it becomes a child of the system and is never waited for. Only functions
// that are safe after fork() are called there.
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

}  // namespace luxel
