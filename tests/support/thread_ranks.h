// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <barrier>
#include <functional>
#include <thread>
#include <vector>

#include "luxel/core/ranks.h"

namespace luxel {

// Ranks that are threads of one process: calls body(rank) in each, and returns when all are done.
class ThreadRanks {
 public:
  static void run(std::size_t count, const std::function<void(const Ranks&)>& body) {
    Hub hub(count);
    std::vector<std::thread> threads;
    for (std::size_t r = 0; r < count; ++r) threads.emplace_back([&, r] { body(Rank(hub, r)); });
    for (auto& thread : threads) thread.join();
  }

 private:
  struct Hub {
    explicit Hub(std::size_t count)
        : barrier(static_cast<std::ptrdiff_t>(count)), given(count), lists(count) {}
    std::barrier<> barrier;
    std::vector<std::span<const std::byte>> given;                   // by each rank
    std::vector<std::span<const std::span<const std::byte>>> lists;  // by each rank
  };

  class Rank final : public Ranks {
   public:
    Rank(Hub& hub, std::size_t rank) : hub_(hub), rank_(rank) {}
    std::size_t rank() const override { return rank_; }
    std::size_t size() const override { return hub_.given.size(); }
    void all_gather(std::span<const std::byte> own, std::span<std::byte> all,
                    std::span<const std::size_t>) const override {
      together([&] { hub_.given[rank_] = own; },
               [&] {
                 auto to = all.begin();
                 for (const auto& part : hub_.given) {
                   if (!part.empty() && part.data() != &*to) std::copy(part.begin(), part.end(), to);
                   to += static_cast<std::ptrdiff_t>(part.size());
                 }
               });
    }
    std::unique_ptr<Pending> start_all_gather(std::span<const std::byte> own,
                                              std::span<std::byte> all) const override {
      return std::make_unique<Later>([=, this] { all_gather(own, all, {}); });
    }
    void gather_to_first(std::span<const std::byte> own, std::span<std::byte> all,
                         std::span<const std::size_t> sizes) const override {
      if (rank_ == 0) return all_gather(own, all, sizes);
      together([&] { hub_.given[rank_] = own; }, [] {});
    }
    void broadcast(std::span<std::byte> bytes) const override {
      const std::vector<std::byte> own(bytes.begin(), bytes.end());
      together([&] { hub_.given[rank_] = own; },
               [&] { std::copy(hub_.given[0].begin(), hub_.given[0].end(), bytes.begin()); });
    }
    void exchange(std::span<const std::span<const std::byte>> own,
                  std::span<const std::span<std::byte>> come) const override {
      together([&] { hub_.lists[rank_] = own; },
               [&] {
                 for (std::size_t r = 0; r < size(); ++r)
                   std::copy(hub_.lists[r][rank_].begin(), hub_.lists[r][rank_].end(), come[r].begin());
               });
    }

   private:
    struct Later final : Pending {
      explicit Later(std::function<void()> call) : gather(std::move(call)) {}
      void wait() override { gather(); }
      std::function<void()> gather;
    };

    template <typename Give, typename Take>
    void together(Give give, Take take) const {
      give();
      hub_.barrier.arrive_and_wait();
      take();
      hub_.barrier.arrive_and_wait();
    }

    Hub& hub_;
    std::size_t rank_;
  };
};

}  // namespace luxel
