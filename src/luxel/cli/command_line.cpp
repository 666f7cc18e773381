// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/command_line.h"

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <sstream>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "luxel/cli/command_words.h"
#include "luxel/cli/help_text.h"
#include "luxel/core/output_file.h"
#include "luxel/core/standard_streams.h"

namespace luxel {
namespace {

// CLI11 splits the words; declarations interpret them.
struct Given {
  std::vector<std::pair<Declaration*, std::vector<std::string>>> options;
  std::string config;
  std::string color = "auto";
  bool print_config = false;
  bool help = false;
  bool help_all = false;
};

void declare(CLI::App& app, Declaration& d, Given& given) {
  auto flags = (d.letter ? fmt::format("-{},", d.letter) : "") + "--" + d.name;
  if (d.is_flag) {
    app.add_flag_function(flags, [&given, &d](std::int64_t) { given.options.push_back({&d, {"true"}}); });
  } else {
    const auto take = [&given, &d](const std::vector<std::string>& texts) {
      given.options.push_back({&d, texts});
    };
    auto* option = app.add_option_function<std::vector<std::string>>(flags, take);
    option->type_size(1)->expected(1);
    if (!d.many) option->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    if (d.many)
      option->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
          ->expected(1, 1 << 20)
          ->allow_extra_args(false);
  }
}

// CLI11 reads "[bake]  # mine" as a key.
std::string without_comments_after_headings(const std::string& text) {
  std::istringstream lines(text);
  std::string result;
  for (std::string line; std::getline(lines, line); result += line + '\n') {
    const auto begin = line.find_first_not_of(" \t");
    const auto end = line.find(']');
    if (begin != std::string::npos && line[begin] == '[' && end != std::string::npos) line.resize(end + 1);
  }
  return result;
}

// The text without the mark that some editors begin UTF-8 with. Throws InputError where it is none.
std::string config_text(const std::string& path) {
  constexpr std::uint64_t max_bytes = 1 << 20;
  constexpr std::string_view mark = "\xef\xbb\xbf";
  auto text = luxel::read_file(path, max_bytes);
  if (text.find('\0') != std::string::npos)
    throw InputError(path, "expected lines of text of the form 'name = value', found binary data or UTF-16");
  if (text.starts_with(mark)) text.erase(0, mark.size());
  return text;
}

// The line of a text file on which a key stands, for the error message; 0 where it is not found.
std::size_t line_of_key(const std::string& text, const std::string& key) {
  std::istringstream lines(text);
  std::string line;
  for (std::size_t number = 1; std::getline(lines, line); ++number) {
    const auto begin = line.find_first_not_of(" \t");
    if (begin == std::string::npos || line.compare(begin, key.size(), key) != 0) continue;
    const auto after = line.find_first_not_of(" \t", begin + key.size());
    if (after != std::string::npos && line[after] == '=') return number;
  }
  return 0;
}

// "luxel" alone prints help, and so does "luxel help" with or without a command.
std::vector<std::string> words_of(int argc, const char* const* argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  if (words.empty()) return {"--help"};
  if (words.front() != "help") return words;
  std::erase(words, "help");
  words.emplace_back("--help");
  return words;
}

bool is_among(const std::string& word, std::initializer_list<const char*> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// Checks that need all options of the line.
void check_given(const OptionSet& chosen, const Given& given) {
  const bool is_alone =
      !chosen.needs_positionals() || std::any_of(given.options.begin(), given.options.end(),
                                                 [](const auto& option) { return option.first->alone; });
  for (const auto& positional : chosen.positionals())
    if (!is_alone && (positional.values ? positional.values->empty() : positional.value->empty()))
      throw UsageError(fmt::format("{} is missing: expected 'luxel {} {}'; 'luxel {} --help' has examples",
                                   positional.name, chosen.name(), positional.name, chosen.name()));
  const auto& color = given.color;
  if (!is_among(color, {"auto", "always", "never"}))
    throw UsageError(fmt::format("--color: expected one of {}, not '{}'", colour_modes, color));
}

HelpStyle help_style() {
  constexpr std::size_t min_columns = 60, max_columns = 100;
  return {paint_for(standard_output), std::clamp(columns_of(standard_output), min_columns, max_columns)};
}

}  // namespace

CommandLine::CommandLine(std::string version) : version_(std::move(version)) {}
CommandLine::~CommandLine() = default;

OptionSet& CommandLine::command(std::string name, std::string summary) {
  commands_.push_back(std::make_unique<OptionSet>(std::move(name), std::move(summary)));
  return *commands_.back();
}

CommandLine::Parsed CommandLine::parse(int argc, const char* const* argv) {
  const auto words = words_of(argc, argv);
  const auto& first = words.front();
  if (is_among(first, {"-V", "--version"})) return {nullptr, fmt::format("luxel {}\n", version_)};
  if (is_among(first, {"-h", "--help", "--help-all"})) return {nullptr, help_of(commands_, help_style())};
  auto& chosen = command_named(first);
  check_words(chosen, std::span(words).subspan(1));

  CLI::App app;
  app.set_help_flag();
  Given given;
  for (auto& positional : chosen.positionals_) {
    if (positional.values)
      app.add_option(positional.name, *positional.values);
    else
      app.add_option(positional.name, *positional.value);
  }
  for (auto& e : chosen.entries_) declare(app, e.declaration, given);
  app.add_option("--config", given.config);
  app.add_option("--color", given.color);
  app.add_flag("--print-config", given.print_config);
  app.add_flag("-h,--help", given.help);
  app.add_flag("--help-all", given.help_all);
  try {
    app.parse(std::vector(words.rbegin(), words.rend() - 1));  // in the order that CLI11 takes them
  } catch (const CLI::ParseError& error) {
    throw UsageError(fmt::format("{}; 'luxel {} --help' explains the command", error.what(), chosen.name_));
  }
  if (given.help || given.help_all) return {nullptr, help_of(chosen, given.help_all, help_style())};
  check_given(chosen, given);

  for (const auto& [declaration, texts] : given.options)
    for (auto& e : chosen.entries_)
      if (&e.declaration == declaration) e.origin = Origin::from_command_line;
  if (!given.config.empty()) read_file(chosen, given.config);
  for (const auto& [declaration, texts] : given.options)
    for (const auto& text : texts) declaration->parse(text);
  chosen.apply_implied();
  chosen.check_use();
  if (given.print_config) return {nullptr, chosen.as_file()};
  return {&chosen, ""};
}

OptionSet& CommandLine::command_named(const std::string& word) const {
  std::vector<std::string> names;
  for (const auto& set : commands_) {
    if (set->name_ == word) return *set;
    names.push_back(set->name_);
  }
  if (word.starts_with('-'))
    throw UsageError(fmt::format("expected a command before '{}': 'luxel help' lists the commands", word));
  if (std::filesystem::exists(word))
    throw UsageError(fmt::format("expected a command before '{}', such as 'luxel bake {}'", word, word));
  throw UsageError(fmt::format("there is no command '{}'{}; 'luxel help' lists the commands", word,
                               did_you_mean(word, names, "")));
}

void CommandLine::read_file(OptionSet& chosen, const std::string& path) {
  const auto text = config_text(path);
  std::istringstream stream(without_comments_after_headings(text));
  std::vector<CLI::ConfigItem> items;
  try {
    items = CLI::ConfigTOML().from_config(stream);
  } catch (const CLI::Error& error) {
    throw InputError(path, std::string("expected lines of the form 'name = value': ") + error.what());
  }
  for (const auto& item : items) {
    if (item.name == "++" || item.name == "--") continue;  // how CLI11 marks a section's begin and end
    const auto fail = [&](const std::string& message) -> InputError {
      const auto line = line_of_key(text, item.name);
      return line > 0 ? InputError(path, line, message) : InputError(path, message);
    };
    // A key under [bake] is for that command; one under no heading is for every command that has it.
    const auto known = [&](const OptionSet& set) {
      return std::any_of(set.entries_.begin(), set.entries_.end(), [&](const OptionSet::Entry& e) {
        return e.declaration.name == item.name && e.declaration.configurable;
      });
    };
    const auto section = fmt::format("{}", fmt::join(item.parents, "."));
    if (std::none_of(commands_.begin(), commands_.end(), [&](const auto& set) {
          return known(*set) && (section.empty() || section == set->name_);
        }))
      throw fail(fmt::format("no command has an option '{}'; 'luxel {} --help' lists them", item.fullname(),
                             chosen.name_));
    if (!section.empty() && section != chosen.name_) continue;
    for (auto& e : chosen.entries_) {
      if (e.declaration.name != item.name || e.origin == Origin::from_command_line) continue;
      e.origin = Origin::from_file;
      try {
        for (const auto& value : item.inputs) e.declaration.parse(value);
      } catch (const UsageError& error) {
        throw fail(error.what());
      }
    }
  }
}

}  // namespace luxel
