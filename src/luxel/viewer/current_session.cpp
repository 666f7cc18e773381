// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/current_session.h"

#include <chrono>
#include <exception>
#include <utility>

namespace luxel {

CurrentSession::~CurrentSession() { close({}); }

void CurrentSession::open(const std::filesystem::path& file) {
  if (next_) retire(std::move(next_));
  try {
    next_ = std::make_unique<ProgressiveSession>(file, settings_(file));
  } catch (const std::exception& error) {
    errors_.emplace_back(error.what());
  }
}

// Closes in the background: it takes a fraction of a second, too long for a frame.
void CurrentSession::retire(std::unique_ptr<ProgressiveSession> scene) {
  std::erase_if(retiring_, [](const auto& each) {
    return each.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  });
  retiring_.push_back(std::async(
      std::launch::async, [old = std::shared_ptr<ProgressiveSession>(std::move(scene))] { old->close(); }));
}

void CurrentSession::take_place() {
  if (shown_) retire(std::move(shown_));
  shown_ = std::move(next_);
  snapshot_ = {};
  errors_seen_ = 0;
  ++number_;
}

void CurrentSession::update() {
  if (next_) {
    const auto next = next_->snapshot();
    // The first scene is shown immediately, so that its progress is visible.
    if (next.mesh || (!shown_ && next.status.errors == 0)) {
      take_place();
    } else if (next.status.errors > 0) {
      errors_.push_back(next.status.error_message);
      retire(std::move(next_));
    }
  }
  if (!shown_) return;
  snapshot_ = shown_->snapshot();
  const auto& status = snapshot_.status;
  if (status.errors > errors_seen_) errors_.push_back(status.error_message);
  errors_seen_ = status.errors;
}

std::string CurrentSession::title() const {
  const auto* const session = shown_ ? shown_.get() : next_.get();
  return session == nullptr ? "" : session->file().filename().string();
}

bool CurrentSession::is_busy() const {
  return next_ != nullptr || (shown_ && (!status().is_idle || status().is_answering));
}

std::vector<std::string> CurrentSession::take_errors() { return std::exchange(errors_, {}); }

CurrentSession::Ending CurrentSession::close(const std::optional<std::filesystem::path>& save) {
  if (next_) retire(std::move(next_));
  Ending ending;
  if (shown_) {
    const auto before = shown_->snapshot().status.errors;
    shown_->close(save);
    const auto after = shown_->snapshot().status;
    if (after.errors > before) ending.error = after.error_message;
    if (save && ending.error.empty() && !after.messages.empty()) ending.saved = after.messages.back().text;
    shown_.reset();
  }
  retiring_.clear();
  return ending;
}

}  // namespace luxel
