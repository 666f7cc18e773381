// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/core/limited_process.h"

namespace luxel {

// Returns the path of the program luxel-import: beside the running program, in ../libexec/luxel of its
// folder, or where Luxel was installed; nothing where it is in none of these.
std::optional<std::filesystem::path> find_converter();

// Limits for a file of this many bytes. Memory: 2 GiB and 40 times the file; processor time: 60 s and 1 s per
// MB; elapsed time: twice as much. Assimp 5.2.5 takes 187 MB and 0.2 s for an FBX of 9 MB
// (360,000 quadrilaterals, compressed), 406 MB and 0.4 s for the same as a DAE of 85 MB.
ProcessLimits converter_limits(std::uintmax_t file_size);

// Runs the converter on a file and returns the GLB that it writes; its messages go to the log, with the name
// of the file. Throws InputError, in one sentence, where there is no converter, or it refuses the file,
// crashes, or exceeds a limit. Returns nothing where the monitor stops the work. converter: nothing for a
// missing one.
std::optional<std::string> converted_file(const std::filesystem::path& path,
                                          const std::optional<std::filesystem::path>& converter,
                                          const ProcessLimits& limits, const Context& context);

}  // namespace luxel
