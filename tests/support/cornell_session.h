// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/session/progressive_session.h"

// The Cornell box in a session, and how tests wait for it.

namespace luxel {

inline const std::string cornell = LUXEL_SOURCE_DIR "/scenes/cornell-box.obj";

// A file of this test; not there yet.
inline std::filesystem::path place(const std::string& name) {
  return std::filesystem::path(testing::TempDir()) / ("luxel-live-" + name);
}
inline std::filesystem::path fresh(const std::string& name) {
  const auto path = place(name);
  std::filesystem::remove(path);
  return path;
}

inline std::string bytes(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline SessionSettings coarse() {
  SessionSettings settings;
  settings.patches.max_edge = 0.5f;
  settings.light.sampled.error = 0.05;
  return settings;
}

// Long enough for anything here on a slow machine.
inline bool wait_until(const std::function<bool()>& is_so) {
  for (int i = 0; i < 30'000; ++i) {
    if (is_so()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return false;
}
inline bool wait_for_idle(const ProgressiveSession& scene) {
  return wait_until([&] {
    const auto status = scene.snapshot().status;
    return status.is_idle && !status.is_answering;
  });
}

// Takes minutes unless stopped.
inline SessionSettings endless() {
  auto settings = coarse();
  settings.light.sampled.error = 1e-6;
  return settings;
}

inline const std::vector<float>& front(const std::shared_ptr<const SessionLight>& light) {
  return light->solution.irradiance.front;
}

}  // namespace luxel
