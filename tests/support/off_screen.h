// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/viewer/screen.h"

namespace luxel::test {

// A test of drawing without a window; skipped where no driver is available.
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
  // The data to draw, once there is a screen.
  virtual void set_up() = 0;

 private:
  ScreenSize size_;
  std::unique_ptr<Screen> screen_;  // destroyed after the objects that use it
};

}  // namespace luxel::test
