// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/refine_progress.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/core/time_left.h"

namespace luxel {
namespace {

// A refinement: the patches of its first mesh, the rays, seconds and error of the first answer there; the
// patches of the last mesh and the seconds until it; and the seconds that the solve to 2 % then took.
struct Refinement {
  std::string name;
  std::size_t first_patches;
  std::uint64_t first_rays;
  double first_seconds, first_error;
  std::size_t patches;
  double seconds, later_seconds;
};

// Runs on two cores.
const std::vector<Refinement> refinements{
    // name, first_patches, first_rays, first_seconds, first_error, patches, seconds, later_seconds
    {"Cornell box", 13'149, 703'274, 0.28, 0.0753, 16'315, 1.0, 0.9},
    {"modern hall", 94'893, 7'318'399, 3.83, 0.0739, 99'856, 8.6, 13.4},
    {"reading room", 97'392, 7'004'375, 3.39, 0.1732, 123'203, 15.4, 40.9},
    {"cafe", 175'958, 11'448'512, 5.47, 0.1775, 217'371, 34.6, 62.3},
    {"classroom", 140'642, 6'750'816, 2.85, 0.1676, 151'968, 13.8, 24.7},
    {"office", 126'201, 9'184'283, 4.02, 0.0688, 154'264, 16.1, 12.7},
    {"stairwell", 75'255, 5'124'045, 2.46, 0.1237, 98'660, 14.4, 16.4},
    {"kitchen", 356'111, 20'192'105, 12.46, 1.6637, 411'621, 55.2, 90.3},
};

// Keeps the last report.
struct Reports {
  Progress last;
  Context context = Context().with_monitor([this](const Progress& progress) {
    last = progress;
    return Next::go_on;
  });
};

TEST(RefineProgress, tells_the_time_of_the_solve_that_follows) {
  for (const auto& run : refinements) {
    Reports reports;
    RefineProgress progress(0.02, 0, reports.context);
    progress.begin_mesh(run.first_patches);
    progress.report_first_mesh(0.5 * run.first_seconds, {"light", 0.5, run.first_rays / 2, 0.0}, 0);
    EXPECT_LT(reports.last.later, 0.0) << run.name << ": no answer yet";
    progress.report_first_mesh(run.first_seconds, {"light", 1.0, run.first_rays, run.first_error}, 0);
    progress.begin_mesh(run.patches);
    progress.report_later_mesh(run.seconds, 1.0, 3 * run.first_rays, 0.02);
    const auto left = time_left(reports.last, run.seconds);
    ASSERT_TRUE(left) << run.name;
    EXPECT_LT(std::max(*left / run.later_seconds, run.later_seconds / *left), 1.5)
        << run.name << ": " << *left;
  }
}

TEST(RefineProgress, expects_the_rays_of_one_answer_where_the_first_is_good_enough_and_the_budget_at_most) {
  Reports reports;
  RefineProgress progress(0.02, 3'000'000, reports.context);
  progress.begin_mesh(1000);
  progress.report_first_mesh(1.0, {"light", 1.0, 1'000'000, 0.015}, 0);
  progress.report_later_mesh(2.0, 1.0, 1'000'000, 0.02);
  const auto one_answer = reports.last.later;
  progress.begin_mesh(2000);
  progress.report_later_mesh(2.0, 1.0, 1'000'000, 0.02);
  EXPECT_DOUBLE_EQ(reports.last.later, 2.0 * one_answer);
  progress.begin_mesh(20'000);
  progress.report_later_mesh(2.0, 1.0, 1'000'000, 0.02);
  EXPECT_NEAR(reports.last.later, 3.6 * one_answer, 1e-9)
      << "of 3 million rays, and what the last round has more";
}

TEST(RefineProgress, says_nothing_of_a_solve_where_none_follows) {
  Reports reports;
  RefineProgress progress(0.0, 0, reports.context);
  progress.begin_mesh(1000);
  progress.report_first_mesh(1.0, {"light", 1.0, 1'000'000, 0.05}, 0);
  progress.report_later_mesh(2.0, 0.5, 1'000'000, 0.02);
  EXPECT_DOUBLE_EQ(reports.last.later, 0.0);
  EXPECT_DOUBLE_EQ(reports.last.done, 0.7);
}

}  // namespace
}  // namespace luxel
