// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/completion.h"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "luxel/cli/help_text.h"

namespace luxel {
namespace {

enum class Takes { nothing, words, files, folders, text };

// An option, or the words without a flag, as a shell completes them.
struct Completed {
  std::string name;
  char letter = 0;
  std::string help;
  Takes takes = Takes::nothing;
  std::vector<std::string> words = {};    // of Takes::words
  std::vector<std::string> endings = {};  // of Takes::files; none: all files
};

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);)
    if (!part.empty()) parts.push_back(part);
  return parts;
}

// Units in capitals are placeholders: all|camera|NAME.
bool is_word(const std::string& text) {
  return std::none_of(text.begin(), text.end(), [](char c) { return c >= 'A' && c <= 'Z'; });
}

Completed completed(const std::string& name, const std::string& unit, const std::string& help,
                    const std::string& endings) {
  Completed result{.name = name, .help = help};
  if (unit.empty()) return result;
  result.takes = unit == "FILE" ? Takes::files : unit == "DIR" ? Takes::folders : Takes::text;
  result.endings = split(endings, ' ');
  if (unit.find('|') == std::string::npos) return result;
  result.takes = Takes::words;
  result.words = split(unit, '|');
  std::erase_if(result.words, [](const auto& word) { return !is_word(word); });
  return result;
}

std::vector<Completed> options_of(const OptionSet& set) {
  std::vector<Completed> options;
  for (const auto& e : set.entries()) {
    const auto& d = e.declaration;
    options.push_back(completed(d.name, d.is_flag ? "" : d.unit, d.help, d.endings));
    options.back().letter = d.letter;
  }
  for (const auto& o : common_options) {
    options.push_back(completed(o.name, o.unit, o.help, ""));
    options.back().letter = o.letter;
  }
  return options;
}

std::vector<std::string> names_of(Commands commands) {
  std::vector<std::string> names{"help"};
  for (const auto& set : commands) names.push_back(set->name());
  return names;
}

// For a text between single quotes of a shell.
std::string inside_quotes(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result;
}

// The first clause of a help text: a line of a list of candidates.
std::string brief(const std::string& help) {
  constexpr std::size_t max_size = 70;
  auto text = help.substr(0, help.find_first_of(";:"));
  if (text.size() <= max_size) return text;
  return text.substr(0, text.rfind(' ', max_size)) + " ...";
}

// ---- bash ----

constexpr const char* bash_head = R"bash(# bash completion of luxel: eval "$(luxel completion bash)"

# Folders, and files with one of the endings (all files without one).
_luxel_files() {
  local ending file
  compopt -o filenames 2> /dev/null
  COMPREPLY=()
  while IFS= read -r file; do COMPREPLY+=("$file"); done < <(
    compgen -d -- "$cur"
    [[ $# -gt 0 ]] || compgen -f -- "$cur"
    for ending in "$@"; do compgen -f -X "!*$ending" -- "$cur"; done
  )
}

_luxel() {
  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD - 1]} command=${COMP_WORDS[1]} options=
  COMPREPLY=()
  if [[ $cur == '=' ]]; then cur=; fi
  if [[ $prev == '=' ]]; then prev=${COMP_WORDS[COMP_CWORD - 2]}; fi
)bash";

std::string bash_values(const Completed& option) {
  switch (option.takes) {
    case Takes::words:
      return fmt::format(R"bash(COMPREPLY=($(compgen -W '{}' -- "$cur")))bash", fmt::join(option.words, " "));
    case Takes::files:
      return fmt::format("_luxel_files {}", fmt::join(option.endings, " "));
    case Takes::folders:
      return R"bash(COMPREPLY=($(compgen -d -- "$cur")))bash";
    case Takes::nothing:
    case Takes::text:
      return ":";
  }
  return ":";
}

std::string bash_case(const OptionSet& set) {
  std::string cases, names;
  for (const auto& option : options_of(set)) {
    names += fmt::format("--{} ", option.name);
    if (option.takes == Takes::nothing) continue;
    auto pattern = fmt::format("'{} --{}'", set.name(), option.name);
    if (option.letter) pattern += fmt::format(" | '{} -{}'", set.name(), option.letter);
    cases += fmt::format("    {}) {}; return ;;\n", pattern, bash_values(option));
  }
  names.pop_back();
  cases += fmt::format("    '{} '*) options='{}' ;;\n", set.name(), names);
  return cases;
}

std::string bash_positional(const OptionSet& set) {
  if (set.positionals().empty()) return {};
  const auto& p = set.positionals().front();
  const auto unit = p.endings.empty() ? p.help : std::string("FILE");
  return fmt::format("    {}) {} ;;\n", set.name(), bash_values(completed(p.name, unit, "", p.endings)));
}

}  // namespace

std::string bash_completion(Commands commands) {
  auto text = std::string(bash_head);
  text += fmt::format(
      "  if ((COMP_CWORD == 1)) || {{ ((COMP_CWORD == 2)) && [[ $command == help ]]; }}; then\n"
      "    COMPREPLY=($(compgen -W '{}' -- \"$cur\"))\n    return\n  fi\n",
      fmt::join(names_of(commands), " "));
  text += "  case \"$command $prev\" in\n";
  for (const auto& set : commands) text += bash_case(*set);
  text +=
      "  esac\n"
      "  if [[ $cur == -* ]]; then COMPREPLY=($(compgen -W \"$options\" -- \"$cur\")); return; fi\n"
      "  case $command in\n";
  for (const auto& set : commands) text += bash_positional(*set);
  return text + "  esac\n}\ncomplete -F _luxel luxel\n";
}

// ---- zsh ----

namespace {

// In a specification of _arguments, brackets and colons have meanings.
std::string zsh_text(const std::string& text) {
  std::string result;
  for (const char c : inside_quotes(text)) {
    if (c == '[' || c == ']' || c == ':') result += '\\';
    result += c;
  }
  return result;
}

std::string zsh_values(const Completed& option) {
  switch (option.takes) {
    case Takes::nothing:
      return "";
    case Takes::words:
      return fmt::format(":value:({})", fmt::join(option.words, " "));
    case Takes::files:
      if (option.endings.empty()) return ":file:_files";
      return fmt::format(":file:_files -g \"*({})\"", fmt::join(option.endings, "|"));
    case Takes::folders:
      return ":folder:_files -/";
    case Takes::text:
      return ":value:";
  }
  return "";
}

std::string zsh_case(const OptionSet& set) {
  auto text = fmt::format("    {})\n      _arguments", set.name());
  for (const auto& option : options_of(set)) {
    const auto rest = fmt::format("[{}]{}", zsh_text(brief(option.help)), zsh_values(option));
    text += fmt::format(" \\\n        '*--{}{}'", option.name, rest);
    if (option.letter) text += fmt::format(" \\\n        '*-{}{}'", option.letter, rest);
  }
  for (const auto& p : set.positionals()) {
    const auto unit = p.endings.empty() ? p.help : std::string("FILE");
    text += fmt::format(" \\\n        '{}{}'", p.values ? "*" : "",
                        zsh_values(completed(p.name, unit, "", p.endings)));
  }
  return text + " ;;\n";
}

}  // namespace

std::string zsh_completion(Commands commands) {
  std::string text =
      "#compdef luxel\n# zsh completion of luxel: luxel completion zsh > a folder of $fpath/_luxel\n\n"
      "_luxel() {\n  local -a commands=(\n";
  for (const auto& set : commands)
    text += fmt::format("    '{}:{}'\n", set->name(), inside_quotes(set->summary()));
  text +=
      "  )\n  if ((CURRENT == 2)); then _describe command commands; return; fi\n"
      "  local command=$words[2]\n  shift words\n  ((CURRENT--))\n  case $command in\n"
      "    help) _describe command commands ;;\n";
  for (const auto& set : commands) text += zsh_case(*set);
  return text + "  esac\n}\n\nif [[ $funcstack[1] == _luxel ]]; then _luxel; else compdef _luxel luxel; fi\n";
}

// ---- fish ----

namespace {

std::string fish_text(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\'' || c == '\\') result += '\\';
    result += c;
  }
  return result;
}

std::string fish_values(const Completed& option) {
  switch (option.takes) {
    case Takes::nothing:
      return "";
    case Takes::words:
      return fmt::format(" -x -a '{}'", fmt::join(option.words, " "));
    case Takes::files:
      if (option.endings.empty()) return " -r -F";
      return fmt::format(" -r -F -a '(__fish_complete_suffix {})'", fmt::join(option.endings, " "));
    case Takes::folders:
      return " -x -a '(__fish_complete_directories)'";
    case Takes::text:
      return " -x";
  }
  return "";
}

}  // namespace

std::string fish_completion(Commands commands) {
  std::string text = "# fish completion of luxel: luxel completion fish | source\n";
  for (const auto& set : commands)
    text += fmt::format("complete -c luxel -n __fish_use_subcommand -f -a {} -d '{}'\n", set->name(),
                        fish_text(set->summary()));
  for (const auto& set : commands) {
    const auto begin = fmt::format("complete -c luxel -n '__fish_seen_subcommand_from {}'", set->name());
    for (const auto& option : options_of(*set)) {
      const auto letter = option.letter ? fmt::format(" -s {}", option.letter) : std::string();
      text += fmt::format("{} -l {}{} -d '{}'{}\n", begin, option.name, letter, fish_text(brief(option.help)),
                          fish_values(option));
    }
    for (const auto& p : set->positionals())
      if (!p.endings.empty()) text += fmt::format("{} -a '(__fish_complete_suffix {})'\n", begin, p.endings);
  }
  return text;
}

}  // namespace luxel
