// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace luxel {

// A file that appears whole or not at all: written beside its place under a temporary name, flushed to the
// disk, then renamed. Until commit() the old file, if any, stays as it was; a destructor without commit()
// removes the temporary.
class OutputFile {
 public:
  // Throws DeviceError, naming the folder, where the folder does not exist or cannot be written.
  explicit OutputFile(std::filesystem::path path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  // Where to write now: in the same folder, with the same ending (libraries choose a format by it).
  const std::filesystem::path& temporary() const { return temporary_; }

  // Flushes and renames. Throws DeviceError with the system's reason (a full disk, say).
  void commit();

 private:
  std::filesystem::path path_;
  std::filesystem::path temporary_;
  bool committed_ = false;
};

// The whole of a buffer as a file, by the same road.
void write_file(const std::filesystem::path& path, std::string_view bytes);

// The whole of a file. Throws InputError naming the file where it cannot be read or is a folder.
std::string read_file(const std::filesystem::path& path);

}  // namespace luxel
