// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace luxel {

/// What a rank has got from the others so far, and how long it has waited for them and for it.
struct Traffic {
  std::uint64_t bytes = 0;
  double seconds = 0.0;
};

/// Processes that solve one scene together. Each holds the scene and takes the same decisions; rows are
/// shared out, and what one of them finds becomes known to all. Every call is made by all ranks, in the same
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

  /// What each rank gives, one after the other: sizes[r] bytes from rank r. The same in all ranks. `own` may
  /// lie in `all`, at its place there.
  virtual void all_gather(std::span<const std::byte> own, std::span<std::byte> all,
                          std::span<const std::size_t> sizes) const = 0;
  /// Likewise, of a few bytes each: as many from every rank. They have come when wait() has returned, which
  /// is soon once all ranks have called. Until then both stay where they are, and there is no other call.
  class Pending {
   public:
    virtual ~Pending() = default;
    virtual void wait() = 0;
  };
  virtual std::unique_ptr<Pending> start_all_gather(std::span<const std::byte> own,
                                                    std::span<std::byte> all) const = 0;
  /// Like all_gather, but in the first rank alone; `all` of the others is not looked at.
  virtual void gather_to_first(std::span<const std::byte> own, std::span<std::byte> all,
                               std::span<const std::size_t> sizes) const = 0;
  /// What the first rank has, in all.
  virtual void broadcast(std::span<std::byte> bytes) const = 0;
  /// own[r]: what this rank has for rank r, read only; come[r]: room for what that one has for this.
  virtual void exchange(std::span<const std::span<const std::byte>> own,
                        std::span<const std::span<std::byte>> come) const = 0;
};

/// The ranks that an MPI launcher (mpirun, srun) started beside this process; none where it was not started
/// so or is alone. Where Luxel was built without MPI it throws if there are others. To be called once, before
/// threads are made.
std::unique_ptr<Ranks> join_ranks();

/// Ends all ranks at once, with this exit code: one of them cannot go on. Returns where there are no others.
void leave_ranks(int exit_code);

}  // namespace luxel
