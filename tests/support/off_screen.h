// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/viewer/screen.h"

namespace luxel::test {

// A test of what is drawn without a window; skipped where nothing draws.
class OffScreen : public testing::Test {
 protected:
  explicit OffScreen(ScreenSize size) : size_(size) {}

  void SetUp() override {
    try {
      screen_ = open_off_screen(size_);
    } catch (const DeviceError& error) {
      GTEST_SKIP() << "nothing draws off screen here: " << error.what();
    }
    set_up();
  }
  // What there is to draw, once there is a screen.
  virtual void set_up() = 0;

 private:
  ScreenSize size_;
  std::unique_ptr<Screen> screen_;  // it goes after what was drawn with it
};

}  // namespace luxel::test
