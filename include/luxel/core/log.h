// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

namespace luxel {

/// error: what was asked cannot be done, or the light will be wrong. warning: it may not be what was meant.
/// note: for information.
enum class Severity { note, warning, error };

/// One sentence for a person, without a line end.
struct Message {
  Severity severity = Severity::note;
  std::string text;
};

/// Where the library says what it noticed. Called from the calling thread only. May be empty: then nothing is
/// said.
using LogSink = std::function<void(const Message&)>;

inline void warn(const LogSink& sink, std::string text) {
  if (sink) sink({Severity::warning, std::move(text)});
}

}  // namespace luxel
