// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

namespace luxel {

enum class Severity { info, warning };

// One sentence for a person, without a line end.
struct Message {
  Severity severity = Severity::info;
  std::string text;
};

// Where the library says what it noticed. Called from the calling thread only. May be empty: then nothing is
// said.
using LogSink = std::function<void(const Message&)>;

inline void warn(const LogSink& sink, std::string text) {
  if (sink) sink({Severity::warning, std::move(text)});
}

}  // namespace luxel
