// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/cli/console.h"

namespace luxel {

// The file that --open shows: the first picture, else the first page, else the first mesh; empty for none.
std::string file_to_open(const std::vector<std::string>& files);

// Opens that file with the desktop's program for it (xdg-open), which outlives this one. Where it cannot be
// started the console reports the reason; the run has succeeded anyway.
void open_one_of(const std::vector<std::string>& files, Console& console);

}  // namespace luxel
