// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/command_words.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include <fmt/format.h>

#include "luxel/cli/help_text.h"
#include "luxel/cli/suggestion.h"

namespace luxel {
namespace {

// An option that a word of a command line may name.
struct Known {
  std::string name;
  std::string unit;  // empty: takes no value
  char letter = 0;
};

// Names of options in other programs, and those of the corresponding options here.
constexpr std::pair<const char*, const char*> other_names[] = {
    {"size", "width"},        {"resolution", "width"}, {"res", "width"},          {"spp", "samples"},
    {"noise", "error"},       {"accuracy", "error"},   {"precision", "error"},    {"camera", "eye"},
    {"position", "eye"},      {"lookat", "target"},    {"look-at", "target"},     {"cores", "threads"},
    {"jobs", "threads"},      {"timeout", "time"},     {"time-limit", "time"},    {"environment", "sky"},
    {"env", "sky"},           {"hdri", "sky"},         {"up-axis", "up"},         {"unit", "scale"},
    {"units", "scale"},       {"format", "output"},    {"subdivide", "max-edge"}, {"tonemap", "tone"},
    {"tone-mapping", "tone"}, {"silent", "quiet"},     {"max-memory", "memory"},  {"preset", "quality"},
};

std::vector<Known> options_of(const OptionSet& command) {
  std::vector<Known> all;
  for (const auto& e : command.entries())
    all.push_back(
        {e.declaration.name, e.declaration.is_flag ? "" : e.declaration.unit, e.declaration.letter});
  for (const auto& o : common_options) all.push_back({o.name, o.unit, o.letter});
  return all;
}

class WordCheck {
 public:
  WordCheck(const OptionSet& command, std::span<const std::string> words)
      : command_(command), words_(words), options_(options_of(command)) {}

  void check() {
    for (at_ = 0; at_ < words_.size() && words_[at_] != "--"; ++at_) {
      const auto& word = words_[at_];
      if (word.starts_with("--"))
        check_long(word);
      else if (word.size() > 1 && word[0] == '-' && std::isalpha(static_cast<unsigned char>(word[1])))
        check_short(word);
      else
        check_positional(word);
    }
  }

 private:
  void check_long(const std::string& word) {
    const auto equals = word.find('=');
    const auto* option = named(word.substr(2, equals - 2));
    if (!option) refuse(word.substr(0, equals), word.substr(2, equals - 2));
    if (!option->unit.empty() && equals == std::string::npos) skip_value(word, *option);
  }

  void check_short(const std::string& word) {
    const auto option =
        std::find_if(options_.begin(), options_.end(), [&](const Known& o) { return o.letter == word[1]; });
    if (option == options_.end() || (word.size() > 2 && named(word.substr(1))))
      refuse(word, word.substr(1, word.find('=') - 1));
    if (!option->unit.empty() && word.size() == 2) skip_value(word, *option);
  }

  void check_positional(const std::string& word) {
    const auto& all = command_.positionals();
    if (!all.empty() && all.back().values) return;
    if (++positionals_ <= all.size()) return;
    std::string names;
    for (const auto& each : all) names += " " + each.name;
    throw UsageError(fmt::format("'{}' is one word too many: expected 'luxel {}{} [options]'", word,
                                 command_.name(), names));
  }

  void skip_value(const std::string& word, const Known& option) {
    if (++at_ == words_.size()) throw UsageError(fmt::format("{} needs a value: <{}>", word, option.unit));
  }

  const Known* named(const std::string& name) const {
    const auto option =
        std::find_if(options_.begin(), options_.end(), [&](const Known& o) { return o.name == name; });
    return option == options_.end() ? nullptr : &*option;
  }

  // The command's option that other programs call so, or the name itself.
  std::string own_name(const std::string& name) const {
    for (const auto& [other, own] : other_names)
      if (name == other && named(own)) return own;
    return name;
  }

  [[noreturn]] void refuse(const std::string& typed, const std::string& name) const {
    std::vector<std::string> names;
    for (const auto& o : options_) names.push_back(o.name);
    const auto wanted = own_name(name);
    throw UsageError(fmt::format("there is no option '{}'{}; 'luxel {} --help-all' lists the options", typed,
                                 did_you_mean(wanted, names, "--"), command_.name()));
  }

  const OptionSet& command_;
  std::span<const std::string> words_;
  std::vector<Known> options_;
  std::size_t at_ = 0;
  std::size_t positionals_ = 0;
};

}  // namespace

std::string did_you_mean(const std::string& word, const std::vector<std::string>& names, const char* before) {
  constexpr std::size_t min_prefix = 3;
  auto name = nearest_name(word, names);
  if (name.empty() && word.size() >= min_prefix) {
    const auto longer =
        std::find_if(names.begin(), names.end(), [&](const auto& n) { return n.starts_with(word); });
    if (longer != names.end()) name = *longer;
  }
  return name.empty() ? "" : fmt::format(", did you mean '{}{}'?", before, name);
}

void check_words(const OptionSet& command, std::span<const std::string> words) {
  WordCheck(command, words).check();
}

}  // namespace luxel
