// SPDX-License-Identifier: Apache-2.0
// The program luxel-import FILE: converts a file and writes the result to standard output, for the reader of
// scenes (import/load_converted.cpp), which runs it under limits of time and memory. Output: lines "note
// SENTENCE" and "warning SENTENCE", an empty line, and the GLB; or one line "error SENTENCE" and exit
// status 1.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>
#include <string_view>

#include "luxel/core/standard_streams.h"
#include "luxel/import/child/convert_foreign.h"
#include "luxel/import/converter_status.h"

#if defined(__SANITIZE_ADDRESS__)
// Assimp's leaks must not change the exit status.
extern "C" const char* __asan_default_options() { return "detect_leaks=0"; }
#endif

namespace {

// Reasons that contain pieces of a file become one line of text.
std::string one_line(std::string_view text) {
  constexpr std::size_t longest = 400;
  std::string line;
  for (const char c : text.substr(0, longest)) line += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  return line + "\n";
}

int convert(const char* path, int output) {
  std::string head;
  try {
    const auto converted = luxel::convert_foreign(path);
    for (const auto& message : converted.messages) head += one_line(message);
    return luxel::write_all(output, head + "\n") && luxel::write_all(output, converted.glb) ? EXIT_SUCCESS
                                                                                            : EXIT_FAILURE;
  } catch (const std::exception& error) {
    luxel::write_all(output, one_line(std::string("error ") + error.what()));
    return luxel::converter_refuses;
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2 || std::string_view(arguments[1]).starts_with("--")) {
    std::puts(
        "Usage: luxel-import FILE\n"
        "Converts .fbx, .dae or .3ds to messages, an empty line and a GLB on standard output.\n"
        "luxel runs it to read such scenes: luxel bake room.fbx");
    return count == 2 ? EXIT_SUCCESS : luxel::converter_refuses;
  }
  std::set_new_handler([] { std::_Exit(luxel::converter_lacks_memory); });
  // Output of Assimp or the C++ runtime must not mix with the result.
  const int output = luxel::take_standard_output();
  if (output < 0) return EXIT_FAILURE;
  return convert(arguments[1], output);
}
