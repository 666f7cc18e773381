// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/give_way.h"

#include <algorithm>
#include <thread>

#include <gtest/gtest.h>
#include <sys/resource.h>

namespace luxel {
namespace {

int nice_value() { return getpriority(PRIO_PROCESS, 0); }

TEST(GiveWay, holds_for_the_thread_that_says_so_and_those_it_starts) {
  const auto before = nice_value();
  int after = -1;
  int of_child = -1;
  std::thread([&] {
    give_way();
    after = nice_value();
    std::thread([&] { of_child = nice_value(); }).join();
  }).join();
  EXPECT_EQ(after, std::min(19, before + 10));
  EXPECT_EQ(of_child, after);
  EXPECT_EQ(nice_value(), before);
}

}  // namespace
}  // namespace luxel
