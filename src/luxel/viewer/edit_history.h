// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace luxel {

// States of something that a person edits, so that changes can be undone and redone. State: copied, compared.
template <typename State>
class EditHistory {
 public:
  static constexpr std::size_t max_states = 200;

  // Begins with this state; discards earlier ones.
  void reset(State state) {
    states_.assign(1, std::move(state));
    now_ = 0;
  }
  // Records the state after a change and discards undone states. Has no effect where the state is the same.
  void note(const State& state) {
    if (states_.empty()) return reset(state);
    if (state == states_[now_]) return;
    states_.resize(now_ + 1);
    states_.push_back(state);
    if (states_.size() > max_states) states_.erase(states_.begin());
    now_ = states_.size() - 1;
  }

  bool can_undo() const { return now_ > 0; }
  bool can_redo() const { return now_ + 1 < states_.size(); }
  // Return the state before the last change, and after the last undone change. Only where one exists.
  const State& undo() { return states_[--now_]; }
  const State& redo() { return states_[++now_]; }

 private:
  std::vector<State> states_;
  std::size_t now_ = 0;
};

}  // namespace luxel
