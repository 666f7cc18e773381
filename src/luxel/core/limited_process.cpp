// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/limited_process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "luxel/core/error.h"

namespace luxel {
namespace {

using Clock = std::chrono::steady_clock;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool has_sanitizer = true;  // its shadow memory is larger than any useful limit
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
constexpr bool has_sanitizer = true;
#else
constexpr bool has_sanitizer = false;
#endif
#else
constexpr bool has_sanitizer = false;
#endif

constexpr int not_started = 127;  // as shells report it

// The functions from here to start() run in the child after fork(), where only calls that are safe in a
// signal handler are allowed: no memory is allocated.

void limit_resource(int resource, std::uint64_t soft, std::uint64_t hard) {
  rlimit limit{};
  const auto which = static_cast<__rlimit_resource_t>(resource);
  if (::getrlimit(which, &limit) != 0) ::_exit(not_started);
  limit.rlim_max = std::min<rlim_t>(limit.rlim_max, hard);
  limit.rlim_cur = std::min<rlim_t>(limit.rlim_max, soft);
  if (::setrlimit(which, &limit) != 0) ::_exit(not_started);
}

void limit_child(const ProcessLimits& limits) {
  limit_resource(RLIMIT_CORE, 0, 0);
  limit_resource(RLIMIT_CPU, limits.cpu_seconds, limits.cpu_seconds + 1);
  if (limits.memory > 0 && !has_sanitizer) limit_resource(RLIMIT_AS, limits.memory, limits.memory);
}

// A signal that the caller ignores or blocks would stay so in the program.
void reset_signals() {
  for (const int number : {SIGPIPE, SIGINT, SIGQUIT, SIGTERM, SIGHUP, SIGXCPU}) ::signal(number, SIG_DFL);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
}

[[noreturn]] void become(char* const* arguments, const ProcessLimits& limits, int output, pid_t parent) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(not_started);  // it ended before the line above
  reset_signals();
  const int nothing = ::open("/dev/null", O_RDWR);
  if (nothing < 0 || ::dup2(nothing, 0) < 0 || ::dup2(output, 1) < 0 || ::dup2(nothing, 2) < 0)
    ::_exit(not_started);
  ::close_range(3, ~0u, 0);
  limit_child(limits);
  ::execv(arguments[0], arguments);
  ::_exit(not_started);
}

class Child {
 public:
  Child(const std::vector<std::string>& command, const ProcessLimits& limits) : limits_(limits) {
    std::vector<std::string> words = command;
    std::vector<char*> arguments;
    for (auto& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail(command[0]);
    const auto parent = ::getpid();
    process_ = ::fork();
    if (process_ == 0) become(arguments.data(), limits, ends[1], parent);
    ::close(ends[1]);
    output_ = ends[0];
    if (process_ < 0) {
      ::close(output_);
      fail(command[0]);
    }
    ::setpgid(process_, process_);  // as the child does itself: one of the two comes first
    ::fcntl(output_, F_SETFL, O_NONBLOCK);
  }
  ~Child() {
    kill();
    ::close(output_);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  ProcessResult wait(const std::function<bool()>& goes_on);

 private:
  enum class Reading { more, no_more, too_much };

  [[noreturn]] static void fail(const std::string& program) {
    throw DeviceError(fmt::format("{} could not be started: {}", program, std::strerror(errno)));
  }

  Reading read_all(std::string& output) const;
  bool has_ended();
  void kill();
  ProcessResult result_of_status() const;

  ProcessLimits limits_;
  pid_t process_ = -1;
  int output_ = -1;
  siginfo_t ended_{};
  bool is_lost_ = false;
};

// Reads the output that is available now.
Child::Reading Child::read_all(std::string& output) const {
  std::array<char, 1 << 16> buffer;
  for (;;) {
    const auto count = ::read(output_, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return Reading::more;
    if (count == 0) return Reading::no_more;
    output.append(buffer.data(), static_cast<std::size_t>(count));
    if (output.size() > limits_.output) return Reading::too_much;
  }
}

// Leaves the ended process in the table of processes, so that its number stays reserved until kill().
bool Child::has_ended() {
  ended_ = {};
  const auto found = ::waitid(P_PID, static_cast<id_t>(process_), &ended_, WEXITED | WNOHANG | WNOWAIT);
  if (found == 0) return ended_.si_pid == process_;
  is_lost_ = errno == ECHILD;  // this program discards the status of all children
  return is_lost_;
}

void Child::kill() {
  if (is_lost_) return;
  ::kill(-process_, SIGKILL);  // and what it has started
  ::kill(process_, SIGKILL);
  while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

ProcessResult Child::result_of_status() const {
  if (is_lost_ || ended_.si_code == CLD_EXITED) return {ProcessEnd::exited, ended_.si_status, {}};
  if (ended_.si_status == SIGXCPU) return {ProcessEnd::out_of_time, 0, {}};
  return {ProcessEnd::killed, ended_.si_status, {}};
}

ProcessResult Child::wait(const std::function<bool()>& goes_on) {
  constexpr int poll_milliseconds = 100;
  const auto end = Clock::now() + std::chrono::duration<double>(limits_.wall_seconds);
  std::string output;
  auto reading = Reading::more;
  for (;;) {
    // The order matters: output written before the process ended must be read.
    const bool is_last = has_ended();
    if (reading == Reading::more) reading = read_all(output);
    if (reading == Reading::too_much) return {ProcessEnd::too_much, 0, {}};
    if (is_last) {
      auto result = result_of_status();
      result.output = std::move(output);
      return result;
    }
    if (!goes_on()) return {ProcessEnd::stopped, 0, {}};
    if (Clock::now() >= end) return {ProcessEnd::out_of_time, 0, {}};
    pollfd waited{output_, POLLIN, 0};
    constexpr int closed_milliseconds = 5;  // until a process that closed its output is gone
    if (reading == Reading::more)
      ::poll(&waited, 1, poll_milliseconds);
    else
      ::poll(nullptr, 0, closed_milliseconds);
  }
}

}  // namespace

ProcessResult run_limited(const std::vector<std::string>& command, const ProcessLimits& limits,
                          const std::function<bool()>& goes_on) {
  Child child(command, limits);
  return child.wait(goes_on);
}

}  // namespace luxel
