// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/session.h"

#include <chrono>
#include <exception>
#include <utility>

namespace luxel {

Session::~Session() { close({}); }

void Session::open(const std::filesystem::path& file) {
  if (coming_) retire(std::move(coming_));
  try {
    coming_ = std::make_unique<LiveScene>(file, settings_(file));
  } catch (const std::exception& error) {
    errors_.emplace_back(error.what());
  }
}

// Closing takes a fraction of a second, which a frame has not.
void Session::retire(std::unique_ptr<LiveScene> scene) {
  std::erase_if(retiring_, [](const auto& each) {
    return each.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  });
  retiring_.push_back(
      std::async(std::launch::async, [old = std::shared_ptr<LiveScene>(std::move(scene))] { old->close(); }));
}

void Session::take_place() {
  if (live_) retire(std::move(live_));
  live_ = std::move(coming_);
  mesh_.reset();
  light_.reset();
  errors_seen_ = 0;
  ++number_;
}

void Session::update() {
  if (coming_) {
    const auto status = coming_->status();
    // The first scene is there at once, so that its progress is seen.
    if (coming_->mesh() || (!live_ && status.errors == 0)) {
      take_place();
    } else if (status.errors > 0) {
      errors_.push_back(status.error_message);
      retire(std::move(coming_));
    }
  }
  if (!live_) return;
  status_ = live_->status();  // first: where it says that all is done, all is there
  mesh_ = live_->mesh();
  light_ = live_->light();
  if (status_.errors > errors_seen_) errors_.push_back(status_.error_message);
  errors_seen_ = status_.errors;
}

std::string Session::title() const {
  const auto* const shown = live_ ? live_.get() : coming_.get();
  return shown == nullptr ? "" : shown->file().filename().string();
}

bool Session::is_busy() const {
  return coming_ != nullptr || (live_ && (!status_.is_idle || status_.is_answering));
}

std::vector<std::string> Session::take_errors() { return std::exchange(errors_, {}); }

Session::Ending Session::close(const std::optional<std::filesystem::path>& save) {
  if (coming_) retire(std::move(coming_));
  Ending ending;
  if (live_) {
    const auto before = live_->status().errors;
    live_->close(save);
    const auto after = live_->status();
    if (after.errors > before) ending.error = after.error_message;
    if (save && ending.error.empty() && !after.messages.empty()) ending.saved = after.messages.back().text;
    live_.reset();
  }
  retiring_.clear();
  return ending;
}

}  // namespace luxel
