// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "luxel/core/log.h"

namespace luxel {

// Messages of the window: short ones on the screen for a few seconds, and errors, each in a
// dialog.
class Notices {
 public:
  void say(std::string sentence);
  void complain(std::string sentence);
  // Shows the messages of a session that are new since the last call.
  void say_new(const std::vector<Message>& messages);
  void begin_session() { messages_seen_ = 0; }
  // Advances the time.
  void advance(double seconds);

  const std::string& said() const { return said_; }                   // empty: nothing
  const std::vector<std::string>& errors() const { return errors_; }  // all there were
  const std::string* dialog() const { return dialogs_.empty() ? nullptr : &dialogs_.front(); }
  void close_dialog() { dialogs_.pop_front(); }  // only while there is one

 private:
  std::string said_;
  double said_left_ = 0.0;  // s
  std::vector<std::string> errors_;
  std::deque<std::string> dialogs_;
  std::size_t messages_seen_ = 0;
};

}  // namespace luxel
