// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "luxel/image/image_file.h"

#include "cli/run_program.h"

namespace luxel::cli {

inline const std::string view =
    "$LUXEL view cornell-box.obj --max-edge 0.1 --error 10% --width 320 --height 240 ";
inline const std::string camera = "--eye 0,0.2744,1.08 --target 0,0.2744,-0.2796 --fov 30 ";

// Mean difference of display values, in [0, 1].
inline double difference(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height) return 1.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c)
      sum += std::abs(srgb_encode(a.pixels[i][c]) - srgb_encode(b.pixels[i][c])) / 3.0;
  return sum / static_cast<double>(a.pixels.size());
}

class View : public testing::Test {
 protected:
  void SetUp() override {
    without_leak_check();
    folder_ = fresh_folder(testing::UnitTest::GetInstance()->current_test_info()->name());
    const auto tried = run("view.txt", "close\n", "--off-screen");
    if (tried.err.find("off screen") != std::string::npos) GTEST_SKIP() << tried.err;
  }
  Outcome run(const std::string& file, const std::string& script, const std::string& options,
              const std::string& before = "") {
    std::ofstream(folder_ / file) << script;
    return cli::run(folder_, before + view + camera + options + " --script " + file);
  }
  Image picture(const std::string& name) const { return read_image(folder_ / name); }

  std::filesystem::path folder_;
};

}  // namespace luxel::cli
