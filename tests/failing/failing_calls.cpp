// SPDX-License-Identifier: Apache-2.0
// Loaded before the C library (LD_PRELOAD), it makes one call of the operating system fail:
// FAIL_CALL="write:3:28" is the third write with the error 28 (ENOSPC); the error 0 is a write of half the
// bytes, without error. Calls for the standard streams do not count.
// SLOW_READS=1000: reads give 1,000 bytes at most, and every third one is interrupted (EINTR), as from some
// folders of a network.
#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/types.h>
#include <unistd.h>

namespace {

// Returns the error with which this call must fail, -1: it must not.
int planned(const char* call) {
  static int left = -1, error = 0;
  static char name[32] = "";
  if (left < 0) {
    const char* plan = std::getenv("FAIL_CALL");
    left = 0;
    if (plan && std::sscanf(plan, "%31[a-z]:%d:%d", name, &left, &error) != 3) std::abort();
  }
  if (left == 0 || std::strcmp(name, call) != 0) return -1;
  --left;
  return left == 0 ? error : -1;
}

bool fails(const char* call) {
  const int error = planned(call);
  if (error > 0) errno = error;
  return error > 0;
}

// Returns how many of `count` bytes this read may give; 0: it is interrupted.
size_t given_by_read(size_t count) {
  static const char* most = std::getenv("SLOW_READS");
  static std::atomic<int> reads = 0;
  if (most == nullptr) return count;
  if (++reads % 3 == 0) return 0;
  return std::min(count, static_cast<size_t>(std::atoi(most)));
}

// The C library's function of this name.
template <typename Function>
Function* real(Function*, const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

// Of calls that write; unnamed files apart, as "tmpfile".
bool open_fails(int flags) {
  if ((flags & O_TMPFILE) == O_TMPFILE) return fails("tmpfile");
  return (flags & (O_WRONLY | O_RDWR)) != 0 && fails("open");
}

bool takes_mode(int flags) { return (flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE; }

}  // namespace

extern "C" {

ssize_t write(int file, const void* bytes, size_t count) {
  auto* next = real(&::write, "write");
  if (file <= STDERR_FILENO) return next(file, bytes, count);
  const int error = planned("write");
  if (error == 0 && count > 1) return next(file, bytes, count / 2);
  if (error <= 0) return next(file, bytes, count);
  errno = error;
  return -1;
}

ssize_t read(int file, void* bytes, size_t count) {
  const auto given = given_by_read(count);
  if (given > 0 || count == 0) return real(&::read, "read")(file, bytes, given);
  errno = EINTR;
  return -1;
}

ssize_t pread64(int file, void* bytes, size_t count, off64_t from) {
  const auto given = given_by_read(count);
  if (given > 0 || count == 0) return real(&::pread64, "pread64")(file, bytes, given, from);
  errno = EINTR;
  return -1;
}

int fsync(int file) { return fails("fsync") ? -1 : real(&::fsync, "fsync")(file); }

int close(int file) {
  auto* next = real(&::close, "close");
  if (file <= STDERR_FILENO) return next(file);
  const int error = planned("close");
  const int result = next(file);
  if (error <= 0) return result;
  errno = error;
  return -1;
}

int rename(const char* from, const char* to) noexcept {
  return fails("rename") ? -1 : real(&::rename, "rename")(from, to);
}

int linkat(int from_folder, const char* from, int to_folder, const char* to, int flags) noexcept {
  return fails("linkat") ? -1 : real(&::linkat, "linkat")(from_folder, from, to_folder, to, flags);
}

int open(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = takes_mode(flags) ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  return open_fails(flags) ? -1 : real(&::open, "open")(path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = takes_mode(flags) ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  return open_fails(flags) ? -1 : real(&::open64, "open64")(path, flags, mode);
}

}  // extern "C"
