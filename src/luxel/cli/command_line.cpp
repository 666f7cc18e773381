// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/command_line.h"

#include <algorithm>
#include <sstream>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "luxel/cli/suggestion.h"
#include "luxel/core/output_file.h"

namespace luxel {
namespace {

// CLI11 splits the words; what a word means is the declaration's business.
struct Given {
  std::vector<std::pair<Declaration*, std::vector<std::string>>> options;
  std::string config;
  bool print_config = false;
};

void declare(CLI::App& app, Declaration& d, const std::string& heading, Given& given) {
  auto flags = (d.letter ? fmt::format("-{},", d.letter) : "") + "--" + d.name;
  CLI::Option* option = nullptr;
  if (d.is_flag) {
    option = app.add_flag_function(
        flags,
        [&given, &d](std::int64_t) {
          given.options.push_back({&d, {"true"}});
        },
        d.help);
  } else {
    const auto take = [&given, &d](const std::vector<std::string>& texts) {
      given.options.push_back({&d, texts});
    };
    option = app.add_option_function<std::vector<std::string>>(flags, take, d.help);
    const auto value = d.print();
    option->option_text(fmt::format("<{}>{}", d.unit, value.empty() ? "" : fmt::format(" [{}]", value)));
    option->type_size(1)->expected(1);
    if (!d.many) option->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    if (d.many)
      option->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
          ->expected(1, 1 << 20)
          ->allow_extra_args(false);
  }
  if (!heading.empty()) option->group(heading);
}

// CLI11 takes "[bake]  # mine" for a key.
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

std::string did_you_mean(const std::string& word, const std::vector<std::string>& names, const char* before) {
  const auto name = nearest_name(word, names);
  return name.empty() ? "" : fmt::format(", did you mean '{}{}'?", before, name);
}

// "luxel" alone is a question for help, and so is "luxel help" with or without a command.
std::vector<std::string> words_of(int argc, const char* const* argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  if (words.empty()) return {"--help"};
  if (words.front() == "help") {
    words.erase(words.begin());
    words.emplace_back("--help");
  }
  return words;
}

}  // namespace

CommandLine::CommandLine(std::string version) : version_(std::move(version)) {}
CommandLine::~CommandLine() = default;

OptionSet& CommandLine::command(std::string name, std::string summary) {
  commands_.push_back(std::make_unique<OptionSet>(std::move(name), std::move(summary)));
  return *commands_.back();
}

CommandLine::Parsed CommandLine::parse(int argc, const char* const* argv) {
  CLI::App app("Luxel: global illumination of diffuse scenes by the radiosity method.", "luxel");
  app.set_version_flag("-V,--version", "luxel " + version_);
  app.require_subcommand(1);
  app.get_formatter()->column_width(38);
  app.footer(
      "'luxel COMMAND --help' explains a command. Exit codes: 0 success, 1 failure, 2 wrong usage, 3 stopped "
      "early.");

  Given given;
  std::vector<CLI::App*> subcommands;
  for (auto& set : commands_) {
    auto* sub = app.add_subcommand(set->name_, set->summary_);
    subcommands.push_back(sub);
    for (auto& positional : set->positionals_) {
      auto* option = positional.values ? sub->add_option(positional.name, *positional.values, positional.help)
                                       : sub->add_option(positional.name, *positional.value, positional.help);
      option->required()->option_text(positional.values ? "... (needed)" : "(needed)");
    }
    for (auto& e : set->entries_) declare(*sub, e.declaration, e.heading, given);
    sub->add_option("--config", given.config, "read options from a text file of 'name = value' lines")
        ->option_text("<FILE>");
    sub->add_flag("--print-config", given.print_config,
                  "print every option with its value and where it came from, and stop");
  }
  auto words = words_of(argc, argv);
  check_names(words);
  try {
    std::reverse(words.begin(), words.end());  // as CLI11 takes them
    app.parse(std::move(words));
  } catch (const CLI::CallForVersion& version) {
    return {nullptr, std::string(version.what()) + "\n"};
  } catch (const CLI::CallForHelp&) {
    const auto chosen = app.get_subcommands();
    return {nullptr, chosen.empty() ? app.help() : chosen.front()->help("luxel")};
  } catch (const CLI::ParseError& error) {
    throw UsageError(
        fmt::format("{}; 'luxel --help' lists commands, 'luxel COMMAND --help' their options", error.what()));
  }

  const auto index =
      std::find_if(subcommands.begin(), subcommands.end(), [](auto* sub) { return sub->parsed(); }) -
      subcommands.begin();
  auto& chosen = *commands_[static_cast<std::size_t>(index)];
  for (const auto& [declaration, texts] : given.options)
    for (auto& e : chosen.entries_)
      if (&e.declaration == declaration) e.origin = Origin::from_command_line;
  if (!given.config.empty()) read_file(chosen, given.config);
  for (const auto& [declaration, texts] : given.options)
    for (const auto& text : texts) declaration->parse(text);
  chosen.check_use();
  if (given.print_config) return {nullptr, chosen.as_file()};
  return {&chosen, ""};
}

void CommandLine::check_names(const std::vector<std::string>& words) const {
  if (words.front().starts_with('-')) return;  // an option of the program
  std::vector<std::string> names;
  const OptionSet* chosen = nullptr;
  for (const auto& set : commands_) {
    names.push_back(set->name_);
    if (set->name_ == words.front()) chosen = set.get();
  }
  if (!chosen)
    throw UsageError(fmt::format("there is no command '{}'{}; 'luxel --help' lists the commands",
                                 words.front(), did_you_mean(words.front(), names, "")));
  names = {"help", "config", "print-config"};
  for (const auto& e : chosen->entries_) names.push_back(e.declaration.name);
  for (std::size_t i = 1; i < words.size() && words[i] != "--"; ++i) {
    if (!words[i].starts_with("--")) continue;
    const auto name = words[i].substr(2, words[i].find('=') - 2);
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    throw UsageError(fmt::format("there is no option '--{}'{}; 'luxel {} --help' lists the options", name,
                                 did_you_mean(name, names, "--"), chosen->name_));
  }
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
    // A key under [bake] is for that command; one under no heading for every command that knows it.
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
