// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/help_text.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "luxel/cli/wrapped_text.h"
#include "luxel/runs/quality.h"

namespace luxel {
namespace {

constexpr std::size_t help_column = 28;
constexpr std::size_t command_column = 15;

// A name in its column, then a text that is wrapped beside it; below it, where the name is too long.
std::string item(const std::string& name, const std::string& text, std::size_t column,
                 const HelpStyle& style) {
  const auto width = width_of(name);
  const auto rest = wrapped(text, {.used = column, .indent = column, .width = style.columns});
  if (width + 2 > column) return fmt::format("{}\n{}{}\n", name, std::string(column, ' '), rest);
  return fmt::format("{}{}{}\n", name, std::string(column - width, ' '), rest);
}

std::string flags_of(char letter, const std::string& name) {
  return letter ? fmt::format("  -{}, --{}", letter, name) : fmt::format("      --{}", name);
}

std::string option_item(const OptionSet::Entry& entry, const HelpStyle& style) {
  const auto& d = entry.declaration;
  auto text = flags_of(d.letter, d.name);
  if (!d.is_flag) text += fmt::format(" <{}>", d.unit);
  if (!d.is_flag && !entry.default_value.empty()) text += fmt::format(" [{}]", entry.default_value);
  return item(text, d.help, help_column, style);
}

std::string option_item(const CommonOption& option, const HelpStyle& style) {
  const auto unit = *option.unit ? fmt::format(" <{}>", option.unit) : std::string();
  return item(flags_of(option.letter, option.name) + unit, option.help, help_column, style);
}

std::string title(const std::string& text, const HelpStyle& style) {
  return fmt::format("\n{}\n", style.paint(Style::label, text));
}

std::string usage(const OptionSet& set) {
  auto text = fmt::format("luxel {}", set.name());
  for (const auto& positional : set.positionals()) {
    const auto name = positional.name + (positional.values ? "..." : "");
    text += set.needs_positionals() ? " " + name : fmt::format(" [{}]", name);
  }
  return text + " [options]";
}

std::string first_options(const OptionSet& set, const HelpStyle& style) {
  auto text = title("Options that people use first", style);
  for (const auto& name : set.first()) {
    const auto entry = std::find_if(set.entries().begin(), set.entries().end(),
                                    [&](const auto& e) { return e.declaration.name == name; });
    text += option_item(*entry, style);
  }
  return text;
}

std::string all_options(const OptionSet& set, const HelpStyle& style) {
  std::string text;
  for (const auto& heading : set.headings()) {
    text += title(heading.empty() ? "Options" : heading, style);
    for (const auto& e : set.entries())
      if (e.heading == heading) text += option_item(e, style);
  }
  text += title("Help and configuration", style);
  for (const auto& o : common_options) text += option_item(o, style);
  const auto table = quality_table(set);
  if (!table.empty()) text += title("Settings of --quality", style) + table;
  return text;
}

std::string examples(const std::vector<OptionSet::Example>& list, const HelpStyle& style) {
  if (list.empty()) return {};
  auto text = title("Examples", style);
  for (const auto& example : list)
    text += fmt::format("  {}\n      {}\n", example.line,
                        wrapped(example.meaning, {.used = 6, .indent = 6, .width = style.columns}));
  return text;
}

}  // namespace

std::string help_of(const OptionSet& set, bool is_whole, const HelpStyle& style) {
  auto text = fmt::format("{} {}\n\n", style.paint(Style::label, "Usage:"), usage(set));
  auto summary = set.summary() + ".";
  summary[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(summary[0])));
  text += wrapped(summary, {.width = style.columns}) + "\n\n";
  for (const auto& positional : set.positionals())
    text += item("  " + positional.name, positional.help, command_column, style);
  const bool is_short = !is_whole && !set.first().empty();
  text += is_short ? first_options(set, style) : all_options(set, style);
  text += examples(set.examples(), style);
  if (is_short)
    text += fmt::format("\n'luxel {} --help-all' lists all {} options.\n", set.name(),
                        set.entries().size() + std::size(common_options));
  return text;
}

std::string help_of(std::span<const std::unique_ptr<OptionSet>> commands, const HelpStyle& style) {
  const auto& paint = style.paint;
  auto text = fmt::format("Luxel: {}.\n\n{} {}\n", program_summary, paint(Style::label, "Usage:"),
                          "luxel COMMAND [options]");
  text += title("Commands", style);
  for (const auto& set : commands) text += item("  " + set->name(), set->summary(), command_column, style);
  text += title("First steps", style);
  const auto step = [&](const char* line, const char* meaning) { text += item(line, meaning, 52, style); };
  step("  luxel bake room.obj", "write room-lit.glb beside the scene");
  step("  luxel bake room.obj -o room.png --quality draft", "a quick picture");
  step("  luxel help bake", "explain a command; 'luxel bake --help-all' has all of it");
  text += title("Exit codes", style);
  for (const auto& exit : exit_codes)
    text += fmt::format("{}{} {}", &exit == exit_codes ? "  " : "   ", exit.code, exit.meaning);
  return text + "\n";
}

}  // namespace luxel
