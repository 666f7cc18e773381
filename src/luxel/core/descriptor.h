// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace luxel {

// An open file of the operating system, closed by the destructor. Private to this module. Where a call fails,
// errno holds the reason.
class Descriptor {
 public:
  // flags as for open(2). New files are readable and writable as the user's umask allows.
  Descriptor(const std::filesystem::path& path, int flags);
  ~Descriptor();
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  bool is_open() const { return number_ >= 0; }
  int number() const { return number_; }
  // Closes the file. Network disks report a full disk only here. Returns false on failure.
  bool close();

 private:
  int number_ = -1;
};

}  // namespace luxel
