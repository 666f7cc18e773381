// SPDX-License-Identifier: Apache-2.0
#include "luxel/runs/quality.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

namespace luxel {
namespace {

constexpr std::array levels = {"draft", "medium", "final"};

struct Row {
  const char* option;
  std::array<const char*, levels.size()> values;  // as the option takes them
};

// The options that each level sets. docs/command-line.md repeats it; a test compares both.
constexpr Row table[] = {
    {"error", {"6%", "2%", "1%"}},             // of the light
    {"ray-budget", {"100M", "400M", "none"}},  // of the light
    {"cheap-rays", {"10M", "40M", "none"}},    // of the light
    {"mesh-error", {"none", "auto", "1%"}},    // of the patches
    {"samples", {"2", "3", "4"}},              // of a pixel
    {"final-gather", {"5%", "2%", "1%"}},      // of lightmaps
};

std::size_t index_of(const std::string& level) {
  return static_cast<std::size_t>(std::find(levels.begin(), levels.end(), level) - levels.begin());
}

bool has(const OptionSet& set, const char* option) {
  return std::any_of(set.entries().begin(), set.entries().end(),
                     [&](const OptionSet::Entry& e) { return e.declaration.name == option; });
}

// Returns whether an option of the table has no effect where the user gave another bound.
bool is_bound(std::string_view option) { return option == "ray-budget" || option == "cheap-rays"; }

}  // namespace

void QualitySettings::declare(OptionSet& set) {
  for (const auto& row : table) set.set_default(row.option, row.values[index_of(level)]);
  Declaration quality{
      .name = "quality",
      .unit = fmt::format("{}|{}|{}", levels[0], levels[1], levels[2]),
      .help = "how accurate and how slow; sets several options at once, but none that you give",
      .parse =
          [this](const std::string& text) {
            if (index_of(text) == levels.size())
              throw UsageError(fmt::format("--quality: expected draft, medium or final, not '{}'", text));
            level = text;
          },
      .print = [this] { return level; },
      .recorded = false,
      .implied =
          [this, &set] {
            std::vector<std::pair<std::string, std::string>> values;
            for (const auto& row : table)
              if (!is_bound(row.option) || has_bound_of_quality(set, row.option))
                values.emplace_back(row.option, row.values[index_of(level)]);
            return values;
          }};
  set.add_first(std::move(quality), "Quality");
}

bool has_bound_of_quality(const OptionSet& set, const std::string& option) {
  return set.is_given(option) || std::none_of(bounds_of_run.begin(), bounds_of_run.end(),
                                              [&](const char* b) { return set.is_given(b); });
}

void drop_bounds_of_quality(OptionSet& set) {
  for (const auto& row : table)
    if (is_bound(row.option) && !has_bound_of_quality(set, row.option)) set.set_default(row.option, "none");
}

std::string quality_table(const OptionSet& set) {
  if (!has(set, "quality")) return {};
  auto text = fmt::format("  {:<16}{:<10}{:<10}{}\n", "--quality", levels[0], levels[1], levels[2]);
  for (const auto& row : table)
    if (has(set, row.option))
      text += fmt::format("  {:<16}{:<10}{:<10}{}\n", fmt::format("--{}", row.option), row.values[0],
                          row.values[1], row.values[2]);
  return text;
}

}  // namespace luxel
