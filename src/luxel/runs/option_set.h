// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "luxel/core/error.h"
#include "luxel/core/vector.h"

namespace luxel {

// A wrong command line: exit code 2.
struct UsageError : Error {
  using Error::Error;
};

// One option: declared once, and that declaration parses it, documents it, reads it from a file and prints it
// back.
struct Declaration {
  std::string name;  // "max-edge": the flag --max-edge and the key max-edge in a file
  std::string unit;  // "m", "count", ... ; stands in the help
  std::string help;
  std::function<void(const std::string&)> parse;  // throws UsageError saying what was expected
  std::function<std::string()> print;             // as parse reads it; for `many`, one per line
  char letter = 0;                                // short form, -o
  bool is_flag = false;                           // present or not
  bool many = false;                              // may be given several times; parse is called for each
  bool configurable = true;                       // may stand in a file
  bool recorded = true;                           // is part of the command that reproduces a result
  bool is_output = false;                         // names files that the command writes
  bool alone = false;                             // where it is given, positionals may be missing
  std::string endings = {};                       // of the files it names, ".png .exr"; for completion
  // Values that it gives to other options that the user did not set: option and value.
  std::function<std::vector<std::pair<std::string, std::string>>()> implied = {};
};

enum class Origin { by_default, implied, from_file, from_command_line };

// The options of one command. command_line.cpp maps them to CLI11.
class OptionSet {
 public:
  OptionSet(std::string name, std::string summary);

  // Options added after this stand under this heading in the help.
  void heading(std::string title) { heading_ = std::move(title); }
  // Options added after this are used only while `choice`, an option declared before, has the value `word`,
  // or one of several separated by '|': on the command line they are refused without it, and they are not
  // recorded. No choice: always used.
  void only_with(std::string choice = {}, std::string word = {});
  void add(Declaration declaration);
  // Adds an option before all others; it is always used.
  void add_first(Declaration declaration, std::string heading);

  // The common kinds. min <= value <= max is checked; the error names the limits.
  void add_number(const char* name, const char* unit, float& value, float min, float max, const char* help);
  void add_number(const char* name, const char* unit, double& value, double min, double max,
                  const char* help);
  void add_number(const char* name, const char* unit, int& value, int min, int max, const char* help);
  void add_number(const char* name, const char* unit, std::uint32_t& value, std::uint32_t min,
                  std::uint32_t max, const char* help);
  // Above 0 and below 1, as "2%" or "0.02".
  void add_fraction(const char* name, double& value, const char* help);
  void add_count(const char* name, std::uint64_t& value, const char* help);  // 50M, 2e6, 1000
  void add_text(const char* name, const char* unit, std::string& value, const char* help);
  // A file that the command writes.
  void add_output(const char* name, std::string& value, const char* help);
  void add_texts(const char* name, const char* unit, std::vector<std::string>& values, const char* help);
  void add_point(const char* name, const char* unit, std::optional<Vec3d>& value, const char* help);  // x,y,z
  void add_choice(const char* name, std::vector<std::string> words, std::string& value, const char* help);
  void add_switch(const char* name, bool& value, const char* help);  // on or off
  void add_flag(const char* name, bool& value, const char* help, bool configurable = true);
  // A word without a flag; called once for each, in the order they are typed. endings: see Declaration.
  void set_positional(const char* name, std::string& value, const char* help, const char* endings = "");
  // One or more words.
  void set_positionals(const char* name, std::vector<std::string>& values, const char* help);
  // Allows the command to run without its positionals.
  void make_positionals_optional() { needs_positionals_ = false; }

  // The options that --help lists, in this order; all others are left to --help-all. They must be declared.
  void show_first(std::vector<std::string> names);
  // Command lines for the end of the help, each with what it does.
  struct Example {
    std::string line, meaning;
  };
  void set_examples(std::vector<Example> examples) { examples_ = std::move(examples); }
  // Changes the default of an option; a name that this set does not have is ignored.
  void set_default(const std::string& name, const std::string& value);

  struct Entry {
    Declaration declaration;
    std::string heading;
    std::string choice, word;  // see only_with
    std::string default_value;
    Origin origin = Origin::by_default;
  };
  struct Positional {
    std::string name;
    std::string* value;                // one word
    std::vector<std::string>* values;  // or several
    std::string help;
    std::string endings;
  };
  const std::vector<Entry>& entries() const { return entries_; }
  const std::vector<Positional>& positionals() const { return positionals_; }
  bool needs_positionals() const { return needs_positionals_; }
  // The headings of the options, in the order of declaration; empty: that of options without one.
  std::vector<std::string> headings() const;
  const std::vector<std::string>& first() const { return first_; }
  const std::vector<Example>& examples() const { return examples_; }

  const std::string& name() const { return name_; }
  const std::string& summary() const { return summary_; }

  // Every option with its value as text, in the order of declaration.
  std::vector<std::pair<std::string, std::string>> values() const;
  // The options that are used, except those under the heading `without`, with their values.
  std::vector<std::pair<std::string, std::string>> used_values(const std::string& without) const;
  // The options that the user gave on the command line or in a file, with their values.
  std::vector<std::pair<std::string, std::string>> given() const;
  // Returns whether the user gave this option; options implied by --quality do not count.
  bool is_given(const std::string& name) const;
  // The positionals and the given options, except those under the heading `without`, as typed.
  std::string given_as_command(const std::string& without) const;
  // Sets the options of these names to these values, as values() or given() of another set returns them;
  // names that this set lacks are ignored. Throws UsageError.
  void restore(const std::vector<std::pair<std::string, std::string>>& values);
  // Returns the arguments that reproduce the result: the positionals, and the options that are used and not
  // at their defaults, but those under the heading `without`.
  std::string as_command(const std::string& without) const;
  // Sets options by name, as if typed on the command line, and the options that they imply; several values of
  // one option are given in sequence. Throws UsageError; std::out_of_range where there is no such option.
  void give(const std::vector<std::pair<std::string, std::string>>& values);
  // Returns a text file that --config reads, with the origin of each value.
  std::string as_file() const;

 private:
  friend class CommandLine;

  Entry* find(const std::string& name);  // null: this set lacks it
  std::string value_of(const std::string& name) const;
  std::string words(const std::function<bool(const Entry&)>& is_shown) const;
  bool is_used(const Entry& entry) const;
  // Throws UsageError where an option of the command line is not used.
  void check_use() const;
  // Sets the values that options imply for others that the user did not set.
  void apply_implied();

  std::string name_;
  std::string summary_;
  std::string heading_;
  std::string choice_, word_;
  std::vector<Entry> entries_;
  std::vector<Positional> positionals_;
  bool needs_positionals_ = true;
  std::vector<std::string> first_;
  std::vector<Example> examples_;
};

// "50M", "1.5e6", "2000": a whole number with an optional k, M or G, for the option --name. Throws
// UsageError.
std::uint64_t parse_count(const std::string& name, const std::string& text);
// The whole text as a number, or nothing.
std::optional<float> parse_number(const std::string& text);
std::optional<double> parse_double(const std::string& text);
std::optional<Vec3d> parse_three(const std::string& text);  // "1.5,0,-2", finite

}  // namespace luxel
