// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/converter.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string_view>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/real_path.h"
#include "luxel/import/converter_status.h"

namespace luxel {
namespace {

constexpr const char* advice = "convert it to glTF (.glb), for example with Blender";
constexpr const char* program_name = "luxel-import";

// alternative: another thing to do, which ends in "or ".
[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& what,
                         const char* alternative = "") {
  throw InputError(path.string(), fmt::format("{}; {}{}", what, alternative, advice));
}

// Takes the first line of a text; nothing where no end of a line is left.
std::optional<std::string_view> take_line(std::string_view& text) {
  const auto end = text.find('\n');
  if (end == text.npos) return std::nullopt;
  const auto line = text.substr(0, end);
  text.remove_prefix(end + 1);
  return line;
}

std::string reason_in(std::string_view output) {
  constexpr std::string_view mark = "error ";
  const auto line = take_line(output);
  if (!line || !line->starts_with(mark)) return "it gives no reason";
  auto reason = line->substr(mark.size());
  while (reason.ends_with('.') || reason.ends_with(' ')) reason.remove_suffix(1);
  return std::string(reason);
}

// Logs the messages, and returns the bytes behind them.
std::string glb_in(std::string output, const std::filesystem::path& path, const Context& context) {
  constexpr std::string_view note = "note ", warning = "warning ", magic = "glTF";
  std::string_view rest = output;
  for (;;) {
    const auto line = take_line(rest);
    if (line && line->starts_with(note)) {
      context.note(fmt::format("{}: {}", path.string(), line->substr(note.size())));
    } else if (line && line->starts_with(warning)) {
      context.warn(fmt::format("{}: {}", path.string(), line->substr(warning.size())));
    } else if (line && line->empty() && rest.starts_with(magic)) {
      output.erase(0, output.size() - rest.size());
      return output;
    } else {
      refuse(path, fmt::format("expected a GLB from the converter {}, found something else", program_name));
    }
  }
}

std::string signal_text(int number) {
  const auto* name = ::strsignal(number);
  return name ? fmt::format("signal {}, {}", number, name) : fmt::format("signal {}", number);
}

// Throws the sentence for each end but success; code is an exit status.
void check_status(const std::filesystem::path& path, int code, const std::string& output,
                  const ProcessLimits& limits) {
  constexpr int not_started = 127;
  if (code == 0) return;
  if (code == converter_refuses)
    refuse(path, fmt::format("Assimp cannot read this file: {}", reason_in(output)), "export it again, or ");
  if (code == converter_lacks_memory)
    refuse(path,
           fmt::format(
               "reading this file takes more than the {:.1f} GB of memory that the converter {} may use; "
               "it is damaged or too large",
               1e-9 * static_cast<double>(limits.memory), program_name));
  if (code == not_started)
    refuse(path, fmt::format("the converter {} does not start", program_name),
           "install its library (Debian: libassimp5), or ");
  refuse(path, fmt::format("the converter {} failed on this file (exit status {}), which is probably damaged",
                           program_name, code));
}

}  // namespace

std::optional<std::filesystem::path> find_converter() {
  std::error_code error;
  const auto own = std::filesystem::read_symlink("/proc/self/exe", error);
  std::vector<std::filesystem::path> places;
  if (!error) {
    places.push_back(own.parent_path() / program_name);
    places.push_back(own.parent_path().parent_path() / "libexec" / "luxel" / program_name);
  }
#ifdef LUXEL_LIBEXEC
  places.push_back(std::filesystem::path(LUXEL_LIBEXEC) / program_name);
#endif
  const auto found = std::find_if(places.begin(), places.end(), is_plain_file);
  return found == places.end() ? std::nullopt : std::optional(*found);
}

ProcessLimits converter_limits(std::uintmax_t file_size) {
  ProcessLimits limits;
  limits.memory = (std::uint64_t{2} << 30) + 40 * std::min<std::uint64_t>(file_size, std::uint64_t{1} << 40);
  limits.cpu_seconds = 60 + file_size / 1'000'000;
  limits.wall_seconds = 2.0 * static_cast<double>(limits.cpu_seconds);
  limits.output = std::uint64_t{4} << 30;  // as a GLB has at most
  return limits;
}

std::optional<std::string> converted_file(const std::filesystem::path& path,
                                          const std::optional<std::filesystem::path>& converter,
                                          const ProcessLimits& limits, const Context& context) {
  if (!converter)
    refuse(path, fmt::format("this format is read by the program {}, which is not installed", program_name),
           "build Luxel with Assimp (Debian: libassimp-dev), or ");
  const auto goes_on = [&] { return context.report({.stage = "load", .done = 0.0}) != Next::stop; };
  auto result = run_limited({converter->string(), std::filesystem::absolute(path).string()}, limits, goes_on);
  switch (result.end) {
    case ProcessEnd::exited:
      check_status(path, result.code, result.output, limits);
      return glb_in(std::move(result.output), path, context);
    case ProcessEnd::killed:
      refuse(path, fmt::format("the converter {} crashed on this file ({}), which is probably damaged",
                               program_name, signal_text(result.code)));
    case ProcessEnd::out_of_time:
      refuse(path, fmt::format(
                       "the converter {} did not finish this file within {} s of processor time or {:g} s in "
                       "all; it is probably damaged",
                       program_name, limits.cpu_seconds, limits.wall_seconds));
    case ProcessEnd::too_much:
      refuse(path, "a converted scene has at most 4 GiB, and this one is larger", "divide it, or ");
    case ProcessEnd::stopped:
      break;
  }
  return std::nullopt;
}

}  // namespace luxel
