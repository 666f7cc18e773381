// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "luxel/core/hint.h"

namespace luxel {

/// error: the request cannot be fulfilled, or the light will be wrong. warning: the result may not be
/// intended. note: for information.
enum class Severity { note, warning, error };

/// One sentence for a person, without a line end.
struct Message {
  Severity severity = Severity::note;
  std::string text;
  std::vector<Hint> hints = {};  ///< settings whose change resolves it
};

/// Receives the messages of the library. It is called from the calling thread only. An empty sink discards
/// them.
using LogSink = std::function<void(const Message&)>;

inline void warn(const LogSink& sink, std::string text, std::vector<Hint> hints = {}) {
  if (sink) sink({Severity::warning, std::move(text), std::move(hints)});
}

}  // namespace luxel
