// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace luxel {

/// Data that a rank has received from the other ranks, and the time it has waited for them.
struct Traffic {
  std::uint64_t exchanges = 0;  ///< calls that sent or received
  std::uint64_t bytes = 0;
  double seconds = 0.0;
  double processor_seconds = 0.0;  ///< of waiting: MPI may poll
};

/// Processes that solve one scene together. Each holds the scene and takes the same decisions; rows are
/// divided among them, and the results of each are distributed to all. All ranks make every call, in the same
/// order, from one thread of each. Throws DeviceError where another rank is gone, if that does not end this
/// one.
class Ranks {
 public:
  virtual ~Ranks() = default;
  virtual std::size_t rank() const = 0;
  virtual std::size_t size() const = 0;
  virtual Traffic traffic() const { return {}; }  ///< where it is measured
  /// Ranks that share this one's memory, itself among them.
  virtual std::size_t on_this_machine() const { return 1; }

  /// Concatenates the data of all ranks in `all`, in every rank: sizes[r] bytes from rank r. `own` may lie in
  /// `all`, at its place there.
  virtual void all_gather(std::span<const std::byte> own, std::span<std::byte> all,
                          std::span<const std::size_t> sizes) const = 0;
  /// Starts all_gather() for a few bytes, equally many from every rank. The data are complete after wait(),
  /// soon after all ranks have called. Until then both buffers must stay in place; no other call is allowed.
  class Pending {
   public:
    virtual ~Pending() = default;
    virtual void wait() = 0;
  };
  virtual std::unique_ptr<Pending> start_all_gather(std::span<const std::byte> own,
                                                    std::span<std::byte> all) const = 0;
  /// Like all_gather, but in the first rank only; `all` of the other ranks is ignored.
  virtual void gather_to_first(std::span<const std::byte> own, std::span<std::byte> all,
                               std::span<const std::size_t> sizes) const = 0;
  /// Copies the data of the first rank to all ranks.
  virtual void broadcast(std::span<std::byte> bytes) const = 0;
  /// Sends own[r], which is only read, to rank r, and receives the data from rank r in come[r].
  virtual void exchange(std::span<const std::span<const std::byte>> own,
                        std::span<const std::span<std::byte>> come) const = 0;
};

/// Returns the ranks that an MPI launcher (mpirun, srun) started beside this process; null where it was not
/// started so or is alone. Throws if there are others but Luxel was built without MPI. Call it once, before
/// threads are made.
std::unique_ptr<Ranks> join_ranks();

/// Terminates all ranks with this exit code, because one cannot continue. Returns if there are no others.
void leave_ranks(int exit_code);

}  // namespace luxel
