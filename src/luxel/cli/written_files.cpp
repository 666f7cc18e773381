// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/written_files.h"

#include <sstream>

#include <fmt/format.h>

#include "luxel/core/output_file.h"
#include "luxel/core/real_path.h"

namespace luxel {
namespace fs = std::filesystem;
namespace {

// The values of an option, one per line.
std::vector<std::string> values_of(const Declaration& declaration) {
  std::istringstream lines(declaration.print());
  std::vector<std::string> values;
  for (std::string line; std::getline(lines, line);)
    if (!line.empty()) values.push_back(line);
  return values;
}

template <typename Use>
void for_each_output(const OptionSet& options, const Use& use) {
  for (const auto& entry : options.entries())
    if (entry.declaration.is_output)
      for (const auto& value : values_of(entry.declaration)) use(entry.declaration, value);
}

}  // namespace

void keep_inputs(const OptionSet& options, const std::vector<fs::path>& inputs) {
  for_each_output(options, [&](const Declaration& output, const std::string& file) {
    if (!is_plain_file(file)) return;
    std::error_code error;
    for (const auto& input : inputs)
      if (fs::equivalent(file, input, error))
        throw UsageError(fmt::format("--{} {}: this file is read for this run ({}); choose another name",
                                     output.name, file, input.string()));
  });
}

void keep_inputs(const OptionSet& options) {
  std::vector<fs::path> inputs;
  const auto add = [&](const std::string& text) {
    // FILE, or FILE:MORE
    for (const auto& name : {text, text.substr(0, text.find(':'))})
      if (is_plain_file(name)) inputs.emplace_back(name);
  };
  for (const auto& positional : options.positionals()) {
    if (positional.value) add(*positional.value);
    if (positional.values)
      for (const auto& value : *positional.values) add(value);
  }
  for (const auto& entry : options.entries())
    if (!entry.declaration.is_output)
      for (const auto& value : values_of(entry.declaration)) add(value);
  keep_inputs(options, inputs);
}

std::string remove_leftovers_of(const OptionSet& options) {
  std::uint64_t bytes = 0;
  for_each_output(options,
                  [&](const Declaration&, const std::string& file) { bytes += remove_leftovers(file); });
  if (bytes == 0) return {};
  return fmt::format("removed {:.1f} MB of temporary files that killed runs left beside the output",
                     1e-6 * static_cast<double>(bytes));
}

}  // namespace luxel
