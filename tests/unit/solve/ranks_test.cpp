// SPDX-License-Identifier: Apache-2.0
// Cooperation of several processes, simulated by threads: the rows of each, and results that do not depend on
// the division.
#include <chrono>
#include <numeric>
#include <optional>

#include <gtest/gtest.h>

#include "luxel/classical/shooting.h"
#include "luxel/lamps/work_units.h"
#include "luxel/patch/make_patches.h"
#include "luxel/patch/patch_tree.h"
#include "luxel/patch/side.h"
#include "luxel/solve/sampled_operator.h"

#include "support/thread_ranks.h"
#include "support/truth_scenes.h"

namespace luxel {
namespace {

double last_time(const std::vector<std::uint32_t>& owners, const std::vector<double>& load,
                 const std::vector<double>& speed) {
  std::vector<double> time(speed.size(), 0.0);
  for (std::size_t b = 0; b < owners.size(); ++b) time[owners[b]] += load[b] / speed[owners[b]];
  return *std::max_element(time.begin(), time.end());
}

std::vector<std::uint32_t> in_turn(std::size_t blocks, std::size_t ranks) {
  std::vector<std::uint32_t> owners;
  for (std::size_t b = 0; b < blocks; ++b) owners.push_back(static_cast<std::uint32_t>(b % ranks));
  return owners;
}

TEST(Balance, ranks_of_one_speed_keep_their_rows) {
  EXPECT_EQ(balanced_owners(in_turn(64, 4), std::vector(64, 1.0), std::vector(4, 2.5)), in_turn(64, 4));
}

TEST(Balance, all_are_done_within_a_block_of_the_mean_and_few_blocks_move) {
  std::vector<double> load(400), speed = {1.0, 3.0, 0.25, 2.0, 2.0};
  for (std::size_t b = 0; b < load.size(); ++b) load[b] = 1.0 + static_cast<double>(b * 7 % 10);
  const auto before = in_turn(load.size(), speed.size());
  const auto after = balanced_owners(before, load, speed);
  const auto mean =
      std::accumulate(load.begin(), load.end(), 0.0) / std::accumulate(speed.begin(), speed.end(), 0.0);
  EXPECT_GT(last_time(before, load, speed), 5.0 * mean);
  EXPECT_LT(last_time(after, load, speed), 1.03 * mean);
  // Those of the slow ranks that are too many, and no others.
  double moved = 0.0, surplus = 0.0;
  for (std::size_t b = 0; b < load.size(); ++b) moved += before[b] != after[b] ? load[b] : 0.0;
  for (std::size_t r = 0; r < speed.size(); ++r) {
    double own = 0.0;
    for (std::size_t b = r; b < load.size(); b += speed.size()) own += load[b];
    surplus += std::max(0.0, own - mean * speed[r]);
  }
  EXPECT_LT(moved, 1.1 * surplus);
}

TEST(Balance, a_block_that_cannot_be_cut_stays) {
  EXPECT_EQ(balanced_owners({0, 1}, std::vector{10.0, 1.0}, std::vector{1.0, 1.0}), in_turn(2, 2));
  EXPECT_EQ(balanced_owners({0, 0}, std::vector{0.0, 0.0}, std::vector{1.0, 1.0}),
            (std::vector<std::uint32_t>{0, 0}));
}

TEST(Balance, work_that_anybody_can_do_takes_the_place_of_blocks_that_would_move) {
  const std::vector<double> load = {6.0, 4.0};
  EXPECT_EQ(balanced_owners({0, 0}, load, std::vector(2, 1.0)), (std::vector<std::uint32_t>{1, 0}));
  EXPECT_EQ(balanced_owners({0, 0}, load, std::vector(2, 1.0), 10.0), (std::vector<std::uint32_t>{0, 0}));
}

TEST(Balance, pieces_go_to_who_is_free_first_as_fast_as_each_is) {
  const ProcessTimes times{{1.0, 2.0, 1.0}, {0.0, 10.0, 40.0}};
  std::vector<double> load;
  for (int i = 0; i < 100; ++i) load.push_back(0.1 + 0.01 * (i * 37 % 100));
  const auto owners = dealt_units(load, times);
  auto ready = times.ready;
  for (std::size_t i = 0; i < load.size(); ++i) ready[owners[i]] += load[i] / times.speed[owners[i]];
  // The last one has enough to do; the others share 60 seconds: x and 2 (x - 10).
  const auto sum = std::accumulate(load.begin(), load.end(), 0.0);
  EXPECT_EQ(ready[2], 40.0);
  EXPECT_NEAR(ready[0], (sum + 20.0) / 3.0, 0.2);
  EXPECT_NEAR(ready[1], (sum + 20.0) / 3.0, 0.2);
}

class RanksTest : public testing::Test {
 protected:
  HitStore make(const SharedWork& work) const {
    return {patches_,
            all_gather_sides(patches_, make_patch_tree(patches_, one_)),
            tracer_,
            {.replicates = 4},
            work};
  }
  static std::vector<std::uint32_t> all_receivers(const HitStore& hits) {
    std::vector<std::uint32_t> receivers(hits.sides().size());
    std::iota(receivers.begin(), receivers.end(), 0u);
    return receivers;
  }
  static std::vector<std::uint32_t> every_third(const HitStore& hits) {
    auto receivers = all_receivers(hits);
    std::erase_if(receivers, [](std::uint32_t s) { return s % 3 > 0; });
    return receivers;
  }

  Context one_{1};
  PatchSet patches_ = make_patches(truth::l_room(), {.max_edge = 0.05f});
  Tracer tracer_{patches_, one_};
};

// The second rank sleeps whenever its monitor is polled: a hundred times as long as its rays take, and longer
// where the machine is busy and they take long.
TEST_F(RanksTest, rows_leave_a_slow_rank_with_all_their_hits) {
  auto alone = make({});
  for (int round = 0; round < 3; ++round) alone.double_rays(all_receivers(alone), 1, one_);
  alone.double_rays(every_third(alone), 8, one_);
  const auto truth = alone.rounds();
  ThreadRanks::run(3, [&](const Ranks& ranks) {
    const Context context({.threads = 1, .ranks = &ranks});
    auto shared = make(SharedWork(context));
    const auto is_slow = ranks.rank() == 1;
    using Clock = std::chrono::steady_clock;
    auto awake = Clock::now();
    const auto monitor = [&](const Progress&) {
      constexpr Clock::duration least = std::chrono::milliseconds(300), most = std::chrono::seconds(3);
      if (is_slow) std::this_thread::sleep_for(std::clamp(20 * (Clock::now() - awake), least, most));
      awake = Clock::now();
      return Next::go_on;
    };
    const auto fraction_of_slow = [&] {
      const auto& owners = shared.partition().owners();
      return static_cast<double>(std::count(owners.begin(), owners.end(), 1u)) /
             static_cast<double>(owners.size());
    };
    EXPECT_GT(fraction_of_slow(), 0.3);
    const auto double_rays = [&](const std::vector<std::uint32_t>& receivers) {
      std::vector<double> more(shared.sides().size(), 0.0);
      for (const auto s : receivers) more[s] = shared.rays_per_receiver()[s];
      const auto times = shared.balance(more, 0.0);
      EXPECT_EQ(times.speed.size(), 3u);
      shared.double_rays(receivers, 1, context.with_monitor(monitor));
    };
    for (int round = 0; round < 3; ++round) double_rays(all_receivers(shared));
    double_rays(every_third(shared));
    EXPECT_LT(fraction_of_slow(), 0.2);
    const auto rounds = shared.rounds();
    ASSERT_EQ(rounds.size(), truth.size());
    for (std::size_t k = 0; k < rounds.size(); ++k) {
      EXPECT_EQ(rounds[k].receivers, truth[k].receivers);
      if (ranks.rank() > 0) continue;
      const auto count = 4 * truth[k].hits_per_replicate();
      EXPECT_TRUE(std::equal(truth[k].hits.get(), truth[k].hits.get() + count, rounds[k].hits.get())) << k;
    }
  });
}

// Each rank holds the arrivals at its own rows from rays of all ranks, and all ranks get the total sums.
TEST_F(RanksTest, rows_that_count_both_ways_have_the_bits_of_one_rank) {
  for (const bool is_streamed : {false, true}) {
    const auto prepare = [&](HitStore& hits) {
      if (is_streamed) hits.stream();
      hits.double_rays(all_receivers(hits), 2, one_);
      hits.double_rays(every_third(hits), 0, one_);
    };
    const auto light = [&](const HitStore& hits) {
      std::vector<float> radiosity(hits.elements() * patches_.band_count());
      for (std::size_t i = 0; i < radiosity.size(); ++i) radiosity[i] = 0.01f * static_cast<float>(i % 89);
      return radiosity;
    };
    auto alone = make({});
    prepare(alone);
    std::vector<float> expected(alone.sides().size() * patches_.band_count());
    SampledOperator(patches_, alone, {}, one_).apply(1, patches_.band_count(), light(alone), expected, one_);
    ThreadRanks::run(3, [&](const Ranks& ranks) {
      const Context context({.threads = 2, .ranks = &ranks});
      auto shared = make(SharedWork(context));
      prepare(shared);
      std::vector<float> irradiance(expected.size());
      SampledOperator(patches_, shared, {}, context)
          .apply(1, patches_.band_count(), light(shared), irradiance, context);
      EXPECT_EQ(irradiance, expected) << (is_streamed ? "streamed" : "stored");
    });
  }
}

// The pace is unknown at first: half, a quarter and a quarter of each rank's work units. Then a rank that was
// late with the first part gets none of the last.
TEST_F(RanksTest, the_last_part_goes_to_who_was_done_with_the_first) {
  const auto sides = all_gather_sides(patches_, make_patch_tree(patches_, one_));
  const std::vector<double> more(sides.size(), 8.0);
  ThreadRanks::run(2, [&](const Ranks& ranks) {
    const RowPartition partition(SharedWork(Context({.threads = 1, .ranks = &ranks})), 1024, sides.position);
    WorkUnits pieces(partition, sides);
    pieces.deal(more, {{1.0, 1.0}, {0.0, 0.0}});
    const auto count_mine = [&](int part) {
      double count = 0.0;
      for (std::size_t s = 0; s < sides.size(); ++s)
        count += pieces.is_mine(s) && pieces.part_of(s) == part ? 1.0 : 0.0;
      return count / static_cast<double>(sides.size());
    };
    EXPECT_NEAR(count_mine(0), 0.25, 0.03);
    EXPECT_NEAR(count_mine(1), 0.125, 0.03);
    EXPECT_NEAR(count_mine(2), 0.125, 0.03);
    pieces.deal_rest({{1.0, 1.0}, {1.0, 1.0 + pieces.expected_seconds(more)}});
    EXPECT_NEAR(count_mine(0), 0.25, 0.03) << "what is done is done";
    EXPECT_NEAR(count_mine(2), ranks.rank() == 0 ? 0.25 : 0.0, 0.05);
  });
}

TEST_F(RanksTest, shot_power_arrives_as_that_of_one_to_the_last_unit) {
  SidePower leaving;
  for (std::uint32_t side = 0; side < side_count(patches_.size()); side += 5) {
    leaving.side.push_back(SideId::at(side));
    for (std::size_t b = 0; b < patches_.band_count(); ++b)
      leaving.watts.push_back(static_cast<double>(1 + side % 7 + b));
  }
  const ShootingOptions options{.rays = 50'000, .batch = 20'000};
  const auto alone = shoot(patches_, tracer_, leaving, options, one_);
  ThreadRanks::run(3, [&](const Ranks& ranks) {
    const Context context({.threads = 1, .ranks = &ranks});
    const auto shared = shoot(patches_, tracer_, leaving, options, context);
    EXPECT_EQ(shared.side, alone.side);
    EXPECT_EQ(shared.arrived, alone.arrived);
    EXPECT_EQ(shared.shot, alone.shot);
    EXPECT_EQ(shared.escaped, alone.escaped);
    EXPECT_EQ(shared.absorbed, alone.absorbed);
    EXPECT_EQ(shared.rays, alone.rays);
  });
}

TEST(LoopPartition, chunks_of_ranks_make_up_the_loop_and_all_know_all) {
  for (const std::size_t count : {0, 1, 9, 10, 11, 95, 100}) {
    ThreadRanks::run(4, [&](const Ranks& ranks) {
      const LoopPartition mine(SharedWork(Context({.threads = 1, .ranks = &ranks})), count, 10);
      std::vector<int> values(2 * count, -1), chunks((count + 9) / 10, -1);
      EXPECT_EQ(mine.begin() % 10, 0u);
      for (auto i = mine.begin(); i < mine.end(); ++i) {
        values[2 * i] = values[2 * i + 1] = static_cast<int>(i);
        chunks[i / 10] = static_cast<int>(i / 10);
      }
      mine.all_gather(std::span(values), 2);
      mine.all_gather_chunks(std::span(chunks));
      for (std::size_t i = 0; i < values.size(); ++i) EXPECT_EQ(values[i], static_cast<int>(i / 2));
      for (std::size_t c = 0; c < chunks.size(); ++c) EXPECT_EQ(chunks[c], static_cast<int>(c));
    });
  }
}

}  // namespace
}  // namespace luxel
