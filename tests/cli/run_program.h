// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <sys/wait.h>

#include "luxel/core/output_file.h"

namespace luxel::cli {

struct Outcome {
  int code = -1;  // exit code; 128 + signal where one ended it
  std::string out, err;
};

// Runs a shell line in which $LUXEL is the program, wherever it lies; the working folder is `folder`.
inline Outcome run(const std::filesystem::path& folder, std::string line) {
  // Spelled out, quoted: the path may hold blanks.
  const std::string word = "$LUXEL";
  const std::string program = "'" LUXEL_PROGRAM "'";
  for (auto at = line.find(word); at != std::string::npos; at = line.find(word, at + program.size()))
    line.replace(at, word.size(), program);
  const auto err = folder / "stderr.txt";
  const auto command = "cd '" + folder.string() + "' && (" + line + ") 2> '" + err.string() + "'";
  Outcome outcome;
  auto* pipe = popen(command.c_str(), "r");
  if (!pipe) return outcome;
  std::array<char, 4096> buffer;
  for (std::size_t n; (n = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    outcome.out.append(buffer.data(), n);
  const int status = pclose(pipe);
  outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  outcome.err = read_file(err);
  return outcome;
}

// Commands of this test end without looking for leaks, where they are built to look: graphics drivers and MPI
// keep memory to the end, and the leak sanitizer itself needs a thread.
inline void without_leak_check() { ::setenv("ASAN_OPTIONS", "detect_leaks=0", 1); }

// Runs a command that is interrupted as by Ctrl-C: `seconds` after the shell condition `begun` holds, in the
// folder, where stderr.txt has the messages so far; after two minutes in any case.
inline Outcome run_interrupted(const std::filesystem::path& folder, const std::string& command,
                               const std::string& begun, const std::string& seconds = "0") {
  return run(folder, command + " & pid=$!; for i in $(seq 2400); do " + begun +
                         " && break; sleep 0.05; done; sleep " + seconds + "; kill -INT $pid; wait $pid");
}

// A fresh folder of this test with our Cornell box and its spectra in it.
inline std::filesystem::path fresh_folder(const std::string& name) {
  const auto folder = std::filesystem::path(testing::TempDir()) / ("luxel_cli_" + name);
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  for (const char* file : {"cornell-box.obj", "cornell-box.mtl", "cornell-spectra.csv"})
    std::filesystem::copy_file(std::filesystem::path(LUXEL_SOURCE_DIR "/scenes") / file, folder / file);
  return folder;
}

// Expects what an interrupt of the solve leaves: the solution a.vtkhdf, and the mesh a.glb whole or, where a
// busy machine did not write it within its second, not at all.
inline void expect_light_is_kept(const std::filesystem::path& folder, const Outcome& interrupted) {
  EXPECT_EQ(interrupted.code, 3) << interrupted.err;
  const auto info = run(folder, "$LUXEL info a.vtkhdf");
  EXPECT_NE(info.out.find("stopped by user"), std::string::npos) << info.out << info.err;
  const bool has_mesh = std::filesystem::exists(folder / "a.glb");
  // Where the second ends between the file and its name, the name is missing.
  const bool is_ended = interrupted.err.find("stopped: no further file is written") != std::string::npos;
  if (!(is_ended && has_mesh)) {
    EXPECT_EQ(interrupted.out, has_mesh ? "a.vtkhdf\na.glb\n" : "a.vtkhdf\n");
  }
  if (has_mesh)
    EXPECT_EQ(run(folder, "$LUXEL info a.glb").code, 0);
  else
    EXPECT_NE(interrupted.err.find("stopped: "), std::string::npos) << interrupted.err;
}

}  // namespace luxel::cli
