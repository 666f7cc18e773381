// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/notices.h"

#include <utility>

namespace luxel {
namespace {

constexpr double said_seconds = 4.0;

}  // namespace

void Notices::say(std::string sentence) {
  said_ = std::move(sentence);
  said_left_ = said_seconds;
}

void Notices::complain(std::string sentence) {
  errors_.push_back(sentence);
  dialogs_.push_back(std::move(sentence));
}

void Notices::say_new(const std::vector<Message>& messages) {
  for (; messages_seen_ < messages.size(); ++messages_seen_) say(messages[messages_seen_].text);
}

void Notices::advance(double seconds) {
  said_left_ -= seconds;
  if (said_left_ <= 0.0) said_.clear();
}

}  // namespace luxel
