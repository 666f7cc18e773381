// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/output_file.h"

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
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

// The file at the end of a chain of links; it need not exist.
fs::path follow_links(fs::path path) {
  constexpr int longest_chain = 40;  // as in Linux
  std::error_code error;
  for (int i = 0; i < longest_chain && fs::is_symlink(path, error); ++i)
    path = path.parent_path() / fs::read_symlink(path, error);
  return path;
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

// Creates a new empty file beside `target`. The process number separates programs, the counter writers within
// one.
fs::path create_beside(const fs::path& path, const fs::path& target) {
  constexpr std::size_t longest_stem = 100;  // leaves room below the 255 bytes of a file name
  constexpr int max_attempts = 1000;
  const auto folder = folder_of(target);
  const auto stem = target.stem().string().substr(0, longest_stem);
  for (int i = 0; i < max_attempts; ++i) {
    auto candidate =
        folder / fmt::format(".{}.{}.{}.tmp{}", stem, ::getpid(), i, target.extension().string());
    const Descriptor file(candidate, O_CREAT | O_EXCL | O_WRONLY);
    if (file.is_open()) return candidate;
    if (errno != EEXIST)
      refuse(path, fmt::format("no file can be made in the folder '{}': {}", folder.string(),
                               std::strerror(errno)));
  }
  refuse(path, EEXIST);
}

void write_all(const fs::path& path, const fs::path& place, std::string_view bytes) {
  Descriptor file(place, O_WRONLY | O_TRUNC);
  if (!file.is_open()) refuse(path, errno);
  while (!bytes.empty()) {
    const auto n = ::write(file.number(), bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) refuse(path, n < 0 ? errno : EIO);
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  if (!file.close()) refuse(path, errno);
}

}  // namespace

OutputFile::OutputFile(fs::path path) : path_(std::move(path)) {
  if (path_.empty()) throw DeviceError("cannot write a file without a name");
  std::error_code error;
  const auto status = fs::status(path_, error);
  if (fs::is_directory(status)) refuse(path_, "it is a folder, expected the name of a file");
  if (fs::exists(status) && ::access(path_.c_str(), W_OK) != 0)
    refuse(path_, fmt::format("it exists and is write-protected ({})", std::strerror(errno)));
  in_place_ = fs::exists(status) && !fs::is_regular_file(status);
  if (in_place_) {
    temporary_ = path_;
    return;
  }
  target_ = follow_links(path_);
  check_folder(path_, folder_of(target_));
  if (target_.filename().empty()) refuse(path_, "expected the name of a file after the folder");
  temporary_ = create_beside(path_, target_);
}

OutputFile::~OutputFile() {
  std::error_code ignored;
  if (!committed_ && !in_place_) fs::remove(temporary_, ignored);
}

void OutputFile::commit() {
  if (!in_place_) {
    Descriptor file(temporary_, O_RDONLY);
    if (!file.is_open() || ::fsync(file.number()) != 0 || !file.close()) refuse(path_, errno);
    struct stat old = {};
    if (::stat(target_.c_str(), &old) == 0) ::chmod(temporary_.c_str(), old.st_mode & 07777);
    if (::rename(temporary_.c_str(), target_.c_str()) != 0) refuse(path_, errno);
    // The new name is durable once the folder is on the disk as well. Some file systems cannot flush a
    // folder; the file is complete anyway, so this is no failure.
    const Descriptor folder(folder_of(target_), O_RDONLY | O_DIRECTORY);
    if (folder.is_open()) ::fsync(folder.number());
  }
  committed_ = true;
}

void write_file(const fs::path& path, std::string_view bytes) {
  OutputFile file(path);
  write_all(path, file.temporary(), bytes);
  file.commit();
}

}  // namespace luxel
