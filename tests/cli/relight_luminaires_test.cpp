// SPDX-License-Identifier: Apache-2.0
// Luminaires are relit: a colour keeps their lumens, in a room whose surfaces are grey.
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "cli/run_program.h"

namespace luxel::cli {
namespace {

// Mean of the illuminances that a calculation plane has, lx.
double mean_lux(const std::filesystem::path& folder, const std::string& solution) {
  const auto done = run(folder, "$LUXEL probe " + solution + " --plane 0.8 --spacing 1 -o plane.csv --quiet");
  EXPECT_EQ(done.code, 0) << done.err;
  std::ifstream file(folder / "plane.csv");
  std::string line;
  std::getline(file, line);
  std::size_t column = 0;
  std::istringstream head(line);
  for (std::string name; std::getline(head, name, ',') && name.find("illuminance") == std::string::npos;)
    ++column;
  double sum = 0.0;
  int count = 0;
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    std::string cell;
    for (std::size_t i = 0; i <= column; ++i) std::getline(cells, cell, ',');
    sum += std::stod(cell);
    ++count;
  }
  EXPECT_GT(count, 5);
  return sum / count;
}

TEST(RelightLuminaires, a_tint_changes_no_lumens_and_a_factor_does) {
  const auto folder = fresh_folder("relight_luminaires");
  std::filesystem::copy_file(LUXEL_SOURCE_DIR "/scenes/luminaires/led-panel.ies", folder / "panel.ies");
  const auto baked = run(folder,
                         "$LUXEL room 6x4x2.8 -o room.obj && $LUXEL bake room.obj --luminaire-grid "
                         "panel.ies:2x2@2.79 --max-edge 0.5 --mesh-error none --error 10% --store-transport "
                         "-o room.vtkhdf --quiet");
  ASSERT_EQ(baked.code, 0) << baked.err;
  const auto relit = [&](const std::string& how, const std::string& file) {
    const auto done = run(folder, "$LUXEL relight room.vtkhdf " + how + " -o " + file + " --quiet");
    EXPECT_EQ(done.code, 0) << done.err;
    return mean_lux(folder, file);
  };
  const auto own = mean_lux(folder, "room.vtkhdf");
  EXPECT_GT(own, 50.0);
  EXPECT_NEAR(relit("--tint 'panel=#ff8020'", "warm.vtkhdf"), own, 1e-3 * own);
  EXPECT_NEAR(relit("--tint panel=0,0,1", "blue.vtkhdf"), own, 1e-3 * own);
  EXPECT_NEAR(relit("--tint panel=0.2", "grey.vtkhdf"), own, 1e-3 * own);
  EXPECT_NEAR(relit("--tint 'panel=#ff8020' --light panel=0.25", "dim.vtkhdf"), 0.25 * own, 1e-3 * own);
}

}  // namespace
}  // namespace luxel::cli
