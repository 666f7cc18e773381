// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace luxel {

// An open file of the operating system, closed when it goes. The room's own tool: only its sources include
// it. Where something fails, errno says why.
class Descriptor {
 public:
  // flags as for open(2). New files are readable and writable as the user's umask allows.
  Descriptor(const std::filesystem::path& path, int flags);
  ~Descriptor();
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  bool is_open() const { return number_ >= 0; }
  int number() const { return number_; }
  // Network disks tell only here that they are full. False where it failed.
  bool close();

 private:
  int number_ = -1;
};

}  // namespace luxel
