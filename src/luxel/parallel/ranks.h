// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

namespace luxel {

// Processes that solve one scene together. Each holds the scene and takes the same decisions; rows are shared
// out, and what one of them finds becomes known to all. Every call is made by all ranks, in the same order,
// from one thread of each. Throws DeviceError where another rank is gone, if that does not end this one.
class Ranks {
 public:
  virtual ~Ranks() = default;
  virtual std::size_t rank() const = 0;
  virtual std::size_t size() const = 0;

  // What each rank gives, one after the other: sizes[r] bytes from rank r. The same in all ranks.
  virtual void all_gather(std::span<const std::byte> own, std::span<std::byte> all,
                          std::span<const std::size_t> sizes) const = 0;
  // Likewise, but in the first rank alone; `all` of the others is not looked at.
  virtual void gather_to_first(std::span<const std::byte> own, std::span<std::byte> all,
                               std::span<const std::size_t> sizes) const = 0;
  // What the first rank has, in all.
  virtual void from_first(std::span<std::byte> bytes) const = 0;
};

}  // namespace luxel
