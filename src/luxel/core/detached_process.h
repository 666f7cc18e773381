// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace luxel {

// Returns the path of a program, as a shell finds it by PATH; empty where there is none.
std::string path_of_program(const std::string& name);

// Starts a program in a session of its own, without the streams of this process, which never waits for it.
// Returns false where the system cannot start a process.
bool start_detached(const std::string& program, const std::string& argument);

}  // namespace luxel
