// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "luxel/core/process_usage.h"
#include "luxel/core/ranks.h"

#ifdef LUXEL_HAS_MPI
#include <mpi.h>

namespace luxel {
namespace {

constexpr std::size_t max_message = std::size_t{1} << 30;  // bytes; MPI counts in int

// Returns whether a launcher started this process: starting MPI without one would cost a tenth of a second.
bool is_launched() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK", "PMI_SIZE"})
    if (std::getenv(name)) return true;
  return false;
}

// A failed call ends all ranks with MPI's own message, which is MPI's default.
class MpiRanks final : public Ranks {
 public:
  MpiRanks() {
    int rank = 0;
    int size = 1;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    rank_ = static_cast<std::size_t>(rank);
    size_ = static_cast<std::size_t>(size);
    MPI_Comm machine = MPI_COMM_NULL;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, rank, MPI_INFO_NULL, &machine);
    MPI_Comm_size(machine, &size);
    on_this_machine_ = static_cast<std::size_t>(size);
    MPI_Comm_free(&machine);
  }
  ~MpiRanks() override { MPI_Finalize(); }
  MpiRanks(const MpiRanks&) = delete;
  MpiRanks& operator=(const MpiRanks&) = delete;

  std::size_t rank() const override { return rank_; }
  std::size_t size() const override { return size_; }
  Traffic traffic() const override { return traffic_; }
  std::size_t on_this_machine() const override { return on_this_machine_; }

  void all_gather(std::span<const std::byte> own, std::span<std::byte> all,
                  std::span<const std::size_t> sizes) const override {
    const auto places = begins(sizes);
    Wait wait(*this, places.back() - own.size());
    if (places.back() <= max_message) {
      const std::vector<int> counts(sizes.begin(), sizes.end());
      const std::vector<int> offsets(places.begin(), places.end() - 1);
      const void* from = own.data() == all.data() + places[rank_] ? MPI_IN_PLACE : own.data();
      MPI_Request request = MPI_REQUEST_NULL;
      MPI_Iallgatherv(from, static_cast<int>(own.size()), MPI_BYTE, all.data(), counts.data(), offsets.data(),
                      MPI_BYTE, MPI_COMM_WORLD, &request);
      wait.until_done({&request, 1});
      return;
    }
    for (std::size_t r = 0; r < size_; ++r) {
      auto part = all.subspan(places[r], sizes[r]);
      if (r == rank_ && own.data() != part.data()) std::copy(own.begin(), own.end(), part.begin());
      broadcast_from(part, static_cast<int>(r), wait);
    }
  }

  std::unique_ptr<Pending> start_all_gather(std::span<const std::byte> own,
                                            std::span<std::byte> all) const override {
    // Point-to-point messages, which need no action of a rank that computes; a collective call would.
    constexpr int tag = 1;
    auto messages = std::make_unique<Messages>(*this);
    const auto count = static_cast<int>(own.size());
    for (std::size_t r = 0; r < size_; ++r) {
      auto* to = all.data() + r * own.size();
      if (r == rank_) {
        std::copy(own.begin(), own.end(), to);
        continue;
      }
      const auto other = static_cast<int>(r);
      MPI_Irecv(to, count, MPI_BYTE, other, tag, MPI_COMM_WORLD, &messages->requests.emplace_back());
      MPI_Isend(own.data(), count, MPI_BYTE, other, tag, MPI_COMM_WORLD, &messages->requests.emplace_back());
    }
    return messages;
  }

  void gather_to_first(std::span<const std::byte> own, std::span<std::byte> all,
                       std::span<const std::size_t> sizes) const override {
    const auto places = begins(sizes);
    Wait wait(*this, rank_ == 0 ? places.back() - own.size() : 0);
    std::vector<MPI_Request> requests;
    if (rank_ > 0) {
      send(own, 0, requests);
    } else {
      std::copy(own.begin(), own.end(), all.begin());
      for (std::size_t r = 1; r < size_; ++r) receive(all.subspan(places[r], sizes[r]), r, requests);
    }
    wait.until_done(requests);
  }

  void broadcast(std::span<std::byte> bytes) const override {
    Wait wait(*this, rank_ == 0 ? 0 : bytes.size());
    broadcast_from(bytes, 0, wait);
  }

  void exchange(std::span<const std::span<const std::byte>> own,
                std::span<const std::span<std::byte>> come) const override {
    std::size_t bytes = 0;
    for (const auto& part : come) bytes += part.size();
    Wait wait(*this, bytes - come[rank_].size());
    std::vector<MPI_Request> requests;
    for (std::size_t r = 0; r < size_; ++r) {
      receive(come[r], r, requests);
      send(own[r], r, requests);
    }
    wait.until_done(requests);
  }

 private:
  // Counts as waiting time of the rank while it exists, without the time in which the rank stood still
  // itself: the others wait for it then.
  class Wait {
   public:
    Wait(const MpiRanks& ranks, std::size_t bytes_come) : traffic_(ranks.traffic_) {
      ++traffic_.exchanges;
      traffic_.bytes += bytes_come;
    }
    ~Wait() {
      traffic_.seconds += std::chrono::duration<double>(last_look_ - begin_).count();
      traffic_.processor_seconds += processor_seconds_of_thread() - processor_begin_;
    }
    Wait(const Wait&) = delete;
    Wait& operator=(const Wait&) = delete;

    // The first look counts from the beginning of the wait: the rank may stand still while it starts the
    // requests.
    void until_done(std::span<MPI_Request> requests) {
      constexpr std::chrono::seconds longest_look{1};  // a look may copy a large message
      for (int is_done = 0; !is_done;) {
        MPI_Testall(static_cast<int>(requests.size()), requests.data(), &is_done, MPI_STATUSES_IGNORE);
        const auto now = std::chrono::steady_clock::now();
        if (now - last_look_ > longest_look) begin_ += now - last_look_;
        last_look_ = now;
        if (!is_done) std::this_thread::yield();
      }
    }

   private:
    Traffic& traffic_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
    std::chrono::steady_clock::time_point last_look_ = begin_;
    double processor_begin_ = processor_seconds_of_thread();
  };

  struct Messages final : Pending {
    explicit Messages(const MpiRanks& of) : ranks(of) {}
    void wait() override {
      Wait wait(ranks, 0);
      wait.until_done(requests);
    }
    const MpiRanks& ranks;
    std::vector<MPI_Request> requests;
  };

  static std::vector<std::size_t> begins(std::span<const std::size_t> sizes) {
    std::vector<std::size_t> places = {0};
    for (const auto size : sizes) places.push_back(places.back() + size);
    return places;
  }
  static int length(std::size_t size, std::size_t from) {
    return static_cast<int>(std::min(max_message, size - from));
  }
  static void send(std::span<const std::byte> bytes, std::size_t to, std::vector<MPI_Request>& requests) {
    for (std::size_t i = 0; i < bytes.size(); i += max_message)
      MPI_Isend(bytes.data() + i, length(bytes.size(), i), MPI_BYTE, static_cast<int>(to), 0, MPI_COMM_WORLD,
                &requests.emplace_back());
  }
  static void receive(std::span<std::byte> bytes, std::size_t from, std::vector<MPI_Request>& requests) {
    for (std::size_t i = 0; i < bytes.size(); i += max_message)
      MPI_Irecv(bytes.data() + i, length(bytes.size(), i), MPI_BYTE, static_cast<int>(from), 0,
                MPI_COMM_WORLD, &requests.emplace_back());
  }
  static void broadcast_from(std::span<std::byte> bytes, int from, Wait& wait) {
    for (std::size_t i = 0; i < bytes.size(); i += max_message) {
      MPI_Request request = MPI_REQUEST_NULL;
      MPI_Ibcast(bytes.data() + i, length(bytes.size(), i), MPI_BYTE, from, MPI_COMM_WORLD, &request);
      wait.until_done({&request, 1});
    }
  }

  std::size_t rank_ = 0;
  std::size_t size_ = 1;
  std::size_t on_this_machine_ = 1;
  mutable Traffic traffic_;
};

}  // namespace

std::unique_ptr<Ranks> join_ranks() {
  if (!is_launched()) return nullptr;
  int level = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &level);
  auto ranks = std::make_unique<MpiRanks>();
  if (ranks->size() > 1) return ranks;
  return nullptr;
}

void leave_ranks(int exit_code) {
  int is_begun = 0;
  int is_ended = 0;
  MPI_Initialized(&is_begun);
  MPI_Finalized(&is_ended);
  if (is_begun && !is_ended) MPI_Abort(MPI_COMM_WORLD, exit_code);
}

}  // namespace luxel

#else

namespace luxel {

// Processes without MPI are unaware of each other and would all write the same files.
std::unique_ptr<Ranks> join_ranks() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"})
    if (const auto* size = std::getenv(name); size && std::atoi(size) > 1)
      throw std::runtime_error(std::string("started as one of ") + size +
                               " processes, but built without MPI: start one alone, or build with MPI");
  return nullptr;
}
void leave_ranks(int) {}

}  // namespace luxel

#endif
