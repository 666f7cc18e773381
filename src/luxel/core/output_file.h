// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace luxel {

// A file that is replaced atomically: written next to its path under a temporary name, flushed to the disk,
// then renamed. Until commit() the old file, if any, is unchanged; a destructor without commit() removes the
// temporary. Symbolic links are preserved: the file that a link points to is replaced, with its permissions
// kept. Special files (/dev/stdout, a pipe) cannot be replaced and are written in place.
class OutputFile {
 public:
  // Throws DeviceError, naming the folder, where the folder does not exist or cannot be written, and where
  // the path is a folder or write-protected.
  explicit OutputFile(std::filesystem::path path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  // Where to write now: an empty file in the same folder, with the same ending (libraries choose a format by
  // it); the path itself where that is no plain file.
  const std::filesystem::path& temporary() const { return temporary_; }

  // Flushes and renames; call it once, with the temporary closed. Throws DeviceError with the system's reason
  // (for example a full disk).
  void commit();

 private:
  std::filesystem::path path_;    // as it was given: for messages
  std::filesystem::path target_;  // links followed
  std::filesystem::path temporary_;
  bool in_place_ = false;
  bool committed_ = false;
};

// The whole of a buffer as a file, by the same road.
void write_file(const std::filesystem::path& path, std::string_view bytes);

// The whole of a file. Throws InputError naming the file where it cannot be read, is a folder, or holds more
// than `most` bytes (a device such as /dev/zero never ends).
std::string read_file(const std::filesystem::path& path, std::uint64_t most = std::uint64_t{4} << 30);

}  // namespace luxel
