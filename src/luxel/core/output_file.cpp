// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/output_file.h"

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "luxel/core/descriptor.h"
#include "luxel/core/error.h"

namespace luxel {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void refuse(const fs::path& path, const std::string& reason) {
  throw cannot_write(path.string(), reason);
}

[[noreturn]] void refuse(const fs::path& path, int error) { refuse(path, std::strerror(error)); }

// Calls again where a signal interrupted the call.
template <typename Call>
bool succeeds(const Call& call) {
  int result = -1;
  do result = call();
  while (result != 0 && errno == EINTR);
  return result == 0;
}

// Links of the system to open files, such as /dev/stdout.
bool is_of_system(const fs::path& path) {
  const auto place = fs::absolute(path).lexically_normal().string();
  return place.starts_with("/dev/") || place.starts_with("/proc/");
}

fs::path folder_of(const fs::path& path) {
  const auto folder = path.parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

void check_folder(const fs::path& path, const fs::path& folder) {
  std::error_code error;
  const auto status = fs::status(folder, error);
  if (status.type() == fs::file_type::not_found)
    refuse(path, fmt::format("the folder '{}' does not exist", folder.string()));
  if (error) refuse(path, error.value());
  if (!fs::is_directory(status)) refuse(path, fmt::format("'{}' is not a folder", folder.string()));
}

std::string stem_of(const fs::path& path) {
  constexpr std::size_t longest_stem = 100;  // leaves room below the 255 bytes of a file name
  return path.stem().string().substr(0, longest_stem);
}

std::string hidden_end(const fs::path& path) { return ".tmp" + path.extension().string(); }

// The process number separates programs, the counter writers within one.
fs::path hidden_name(const fs::path& path, int i) {
  return folder_of(path) / fmt::format(".{}.{}.{}{}", stem_of(path), ::getpid(), i, hidden_end(path));
}
constexpr int max_attempts = 1000;

// Marks a hidden file as one whose writer lives. Without effect where the file system has no locks.
bool lock(const Descriptor& file) { return ::flock(file.number(), LOCK_EX | LOCK_NB) == 0; }

bool has_name(const Descriptor& file) {
  struct stat status = {};
  return ::fstat(file.number(), &status) == 0 && status.st_nlink > 0;
}

}  // namespace

OutputFile::OutputFile(fs::path path) : path_(std::move(path)) {
  if (path_.empty()) throw DeviceError("cannot write a file without a name");
  std::error_code error;
  const auto status = fs::status(path_, error);
  const bool is_link = fs::is_symlink(path_, error);
  if (fs::is_directory(status)) refuse(path_, "it is a folder, expected the name of a file");
  const bool holds_nothing = fs::is_character_file(status) || fs::is_fifo(status);
  if (is_link && !is_of_system(path_) && !holds_nothing)
    refuse(path_,
           "it is a symbolic link, and these are not followed; name the file itself, or remove the link");
  if (fs::exists(status) && ::access(path_.c_str(), W_OK) != 0)
    refuse(path_, fmt::format("it exists and is write-protected ({})", std::strerror(errno)));
  in_place_ = fs::exists(status) && (is_link || !fs::is_regular_file(status));
  if (in_place_) return;  // opening a pipe waits for its reader
  check_folder(path_, folder_of(path_));
  if (path_.filename().empty()) refuse(path_, "expected the name of a file after the folder");
  open_unnamed();
  if (!file_) open_hidden();
}

OutputFile::~OutputFile() {
  if (!hidden_.empty()) ::unlink(hidden_.c_str());
}

void OutputFile::open_in_place() {
  file_ = std::make_unique<Descriptor>(path_, O_WRONLY | O_TRUNC);
  if (!file_->is_open()) refuse(path_, errno);
}

// Only /proc can give an unnamed file its name later.
void OutputFile::open_unnamed() {
  if (::access("/proc/self/fd", F_OK) != 0) return;
  auto file = std::make_unique<Descriptor>(folder_of(path_), O_TMPFILE | O_WRONLY);
  if (file->is_open()) file_ = std::move(file);
}

void OutputFile::open_hidden() {
  for (int i = 0; i < max_attempts; ++i) {
    const auto candidate = hidden_name(path_, i);
    auto file = std::make_unique<Descriptor>(candidate, O_CREAT | O_EXCL | O_WRONLY);
    if (!file->is_open() && errno != EEXIST)
      refuse(path_, fmt::format("no file can be made in the folder '{}': {}", folder_of(path_).string(),
                                std::strerror(errno)));
    if (!file->is_open()) continue;
    lock(*file);
    if (!has_name(*file)) continue;  // another program took it for a leftover before it was locked
    hidden_ = candidate;
    file_ = std::move(file);
    return;
  }
  refuse(path_, EEXIST);
}

void OutputFile::give_hidden_name() {
  lock(*file_);
  const auto open_file = fmt::format("/proc/self/fd/{}", file_->number());
  for (int i = 0; i < max_attempts; ++i) {
    const auto candidate = hidden_name(path_, i);
    if (succeeds([&] {
          return ::linkat(AT_FDCWD, open_file.c_str(), AT_FDCWD, candidate.c_str(), AT_SYMLINK_FOLLOW);
        })) {
      hidden_ = candidate;
      return;
    }
    if (errno != EEXIST) break;
  }
  refuse(path_, errno);
}

void OutputFile::write(std::string_view bytes) {
  if (in_place_ && !file_) open_in_place();
  while (!bytes.empty()) {
    const auto n = ::write(file_->number(), bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) refuse(path_, n < 0 ? errno : EIO);
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
}

void OutputFile::commit() {
  if (in_place_) {
    if (file_ && !file_->close()) refuse(path_, errno);
    return;
  }
  struct stat old = {};
  if (::lstat(path_.c_str(), &old) == 0 && S_ISREG(old.st_mode))
    ::fchmod(file_->number(), old.st_mode & 07777);
  if (!succeeds([&] { return ::fsync(file_->number()); })) refuse(path_, errno);
  if (hidden_.empty()) give_hidden_name();
  if (!file_->close()) refuse(path_, errno);
  if (!succeeds([&] { return ::rename(hidden_.c_str(), path_.c_str()); })) refuse(path_, errno);
  hidden_.clear();
  // The new name is durable once the folder is on the disk as well. Some file systems cannot flush a
  // folder; the file is complete anyway, so this is no failure.
  const Descriptor folder(folder_of(path_), O_RDONLY | O_DIRECTORY);
  if (folder.is_open()) ::fsync(folder.number());
}

std::uint64_t remove_leftovers(const fs::path& path) {
  std::uint64_t bytes = 0;
  std::error_code error;
  const auto begin = fmt::format(".{}.", stem_of(path)), end = hidden_end(path);
  for (const auto& entry : fs::directory_iterator(folder_of(path), error)) {
    const auto name = entry.path().filename().string();
    if (!name.starts_with(begin) || !name.ends_with(end)) continue;
    const Descriptor file(entry.path(), O_WRONLY | O_NOFOLLOW | O_NONBLOCK);
    struct stat status = {};
    if (!file.is_open() || ::fstat(file.number(), &status) != 0 || !S_ISREG(status.st_mode)) continue;
    if (!lock(file) || ::unlink(entry.path().c_str()) != 0) continue;
    bytes += static_cast<std::uint64_t>(status.st_size);
  }
  return bytes;
}

void write_file(const fs::path& path, std::string_view bytes) {
  OutputFile file(path);
  file.write(bytes);
  file.commit();
}

}  // namespace luxel
