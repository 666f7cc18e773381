// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace luxel {

// Exit statuses of the converter luxel-import besides 0; any other one counts as a crash.
enum ConverterStatus : int {
  converter_refuses = 1,       // its output is "error SENTENCE"
  converter_lacks_memory = 3,  // an allocation failed
};

}  // namespace luxel
