// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace luxel {

class Descriptor;

// A file that is replaced atomically: written without a name in the folder of its path, flushed to the disk,
// then named. Until commit() the old file, if any, is unchanged; without commit() no new file remains, even
// if the process is killed. File systems without unnamed files get a hidden one, `.STEM.*.tmp.EXTENSION`,
// which is locked as long as its writer lives. Special files (/dev/stdout, a pipe) cannot be replaced and are
// written in place. Links to files are not followed: their author would choose which file is overwritten.
class OutputFile {
 public:
  // Throws DeviceError, naming the folder, where the folder does not exist or cannot be written, and where
  // the path is a folder, a link or write-protected.
  explicit OutputFile(std::filesystem::path path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  // Appends. Throws DeviceError with the system's reason (for example a full disk), as commit() does.
  void write(std::string_view bytes);

  // Flushes and renames; call it once, at the end.
  void commit();

 private:
  void open_in_place();
  void open_unnamed();
  void open_hidden();
  void give_hidden_name();

  std::filesystem::path path_;    // as it was given
  std::filesystem::path hidden_;  // the file's name until commit(); empty: it has none
  std::unique_ptr<Descriptor> file_;
  bool in_place_ = false;
};

// Removes hidden files beside this one that killed writers left and that no process has locked. Returns their
// bytes.
std::uint64_t remove_leftovers(const std::filesystem::path& path);

// The whole of a buffer as a file, by the same road.
void write_file(const std::filesystem::path& path, std::string_view bytes);

// The whole of a file. Throws InputError naming the file where it cannot be read, is a folder, or holds more
// than `most` bytes (a device such as /dev/zero never ends).
std::string read_file(const std::filesystem::path& path, std::uint64_t most = std::uint64_t{4} << 30);

}  // namespace luxel
