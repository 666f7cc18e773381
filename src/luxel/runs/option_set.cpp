// SPDX-License-Identifier: Apache-2.0
#include "luxel/runs/option_set.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace luxel {
namespace {

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) result.push_back(line);
  return result;
}

// Quotes a word for a shell.
std::string quoted(const std::string& word) {
  constexpr auto plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=:,./@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string inside;
  for (const char c : word) inside += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return fmt::format("'{}'", inside);
}

const char* word(Origin origin) {
  switch (origin) {
    case Origin::by_default:
      return "default";
    case Origin::implied:
      return "quality";
    case Origin::from_file:
      return "file";
    case Origin::from_command_line:
      return "command line";
  }
  return "";
}

}  // namespace

OptionSet::OptionSet(std::string name, std::string summary)
    : name_(std::move(name)), summary_(std::move(summary)) {}

void OptionSet::add(Declaration declaration) {
  // An empty value of a list would be lost where the list is printed, a value a line.
  if (declaration.many)
    declaration.parse = [parse = std::move(declaration.parse), name = declaration.name,
                         value = declaration.unit](const std::string& text) {
      if (text.empty()) throw UsageError(fmt::format("--{}: expected {}, found nothing", name, value));
      parse(text);
    };
  auto default_value = declaration.print();
  entries_.push_back({std::move(declaration), heading_, choice_, word_, std::move(default_value)});
}

void OptionSet::add_first(Declaration declaration, std::string heading) {
  auto default_value = declaration.print();
  entries_.insert(entries_.begin(),
                  {std::move(declaration), std::move(heading), "", "", std::move(default_value)});
}

void OptionSet::only_with(std::string choice, std::string word) {
  choice_ = std::move(choice);
  word_ = std::move(word);
}

void OptionSet::set_positional(const char* name, std::string& value, const char* help, const char* endings) {
  positionals_.push_back({name, &value, nullptr, help, endings});
}

void OptionSet::set_positionals(const char* name, std::vector<std::string>& values, const char* help) {
  positionals_.push_back({name, nullptr, &values, help, ".vtkhdf"});
}

void OptionSet::show_first(std::vector<std::string> names) {
  for (const auto& name : names)
    if (!find(name)) throw std::logic_error(fmt::format("luxel {} has no option --{}", name_, name));
  first_ = std::move(names);
}

OptionSet::Entry* OptionSet::find(const std::string& name) {
  const auto entry = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const Entry& e) { return e.declaration.name == name; });
  return entry == entries_.end() ? nullptr : &*entry;
}

void OptionSet::set_default(const std::string& name, const std::string& value) {
  auto* entry = find(name);
  if (!entry) return;
  entry->declaration.parse(value);
  entry->default_value = entry->declaration.print();
}

void OptionSet::apply_implied() {
  for (const auto& e : entries_) {
    if (!e.declaration.implied) continue;
    for (const auto& [name, value] : e.declaration.implied()) {
      auto* other = find(name);
      if (!other || other->origin != Origin::by_default || other->declaration.print() == value) continue;
      other->declaration.parse(value);
      other->origin = Origin::implied;
    }
  }
}

std::vector<std::string> OptionSet::headings() const {
  std::vector<std::string> result;
  for (const auto& e : entries_)
    if (std::find(result.begin(), result.end(), e.heading) == result.end()) result.push_back(e.heading);
  return result;
}

std::vector<std::pair<std::string, std::string>> OptionSet::values() const {
  std::vector<std::pair<std::string, std::string>> result;
  for (const auto& e : entries_)
    if (e.declaration.configurable) result.emplace_back(e.declaration.name, e.declaration.print());
  return result;
}

std::vector<std::pair<std::string, std::string>> OptionSet::used_values(const std::string& without) const {
  std::vector<std::pair<std::string, std::string>> result;
  for (const auto& e : entries_)
    if (e.declaration.configurable && e.declaration.recorded && e.heading != without && is_used(e))
      result.emplace_back(e.declaration.name, e.declaration.print());
  return result;
}

std::vector<std::pair<std::string, std::string>> OptionSet::given() const {
  std::vector<std::pair<std::string, std::string>> result;
  for (const auto& e : entries_)
    if (e.origin != Origin::by_default && e.declaration.recorded)
      result.emplace_back(e.declaration.name, e.declaration.print());
  return result;
}

bool OptionSet::is_given(const std::string& name) const {
  return std::any_of(entries_.begin(), entries_.end(), [&](const Entry& e) {
    return e.declaration.name == name && e.origin != Origin::by_default && e.origin != Origin::implied;
  });
}

void OptionSet::restore(const std::vector<std::pair<std::string, std::string>>& values) {
  for (const auto& [name, value] : values)
    for (auto& e : entries_)
      if (e.declaration.name == name && value != e.declaration.print()) {
        e.origin = Origin::from_file;
        for (const auto& text : e.declaration.many ? lines(value) : std::vector{value})
          e.declaration.parse(text);
      }
}

void OptionSet::give(const std::vector<std::pair<std::string, std::string>>& values) {
  for (const auto& [name, value] : values) {
    auto* entry = find(name);
    if (!entry) throw std::out_of_range(fmt::format("{} has no option '{}'", name_, name));
    entry->origin = Origin::from_command_line;
    entry->declaration.parse(value);
  }
  apply_implied();
  check_use();
}

std::string OptionSet::value_of(const std::string& name) const {
  const auto entry = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const Entry& e) { return e.declaration.name == name; });
  return entry == entries_.end() ? std::string() : entry->declaration.print();
}

bool OptionSet::is_used(const Entry& entry) const {
  if (entry.choice.empty()) return true;
  return fmt::format("|{}|", entry.word).find(fmt::format("|{}|", value_of(entry.choice))) !=
         std::string::npos;
}

void OptionSet::check_use() const {
  for (const auto& e : entries_)
    if (e.origin == Origin::from_command_line && !is_used(e))
      throw UsageError(
          fmt::format("--{} needs --{} {} and has no effect with --{} {}: remove it or change the "
                      "other",
                      e.declaration.name, e.choice, e.word, e.choice, value_of(e.choice)));
}

std::string OptionSet::words(const std::function<bool(const Entry&)>& is_shown) const {
  auto text = fmt::format("luxel {}", name_);
  for (const auto& positional : positionals_)
    for (const auto& word : positional.values ? *positional.values : std::vector{*positional.value})
      text += fmt::format(" {}", quoted(word));
  for (const auto& e : entries_) {
    if (!is_shown(e)) continue;
    for (const auto& value : lines(e.declaration.print()))
      text += fmt::format(" --{}{}{}", e.declaration.name, e.declaration.is_flag ? "" : " ",
                          e.declaration.is_flag ? "" : quoted(value));
  }
  return text;
}

std::string OptionSet::as_command(const std::string& without) const {
  return words([&](const Entry& e) {
    return e.declaration.recorded && e.declaration.print() != e.default_value && e.heading != without &&
           is_used(e);
  });
}

std::string OptionSet::given_as_command(const std::string& without) const {
  return words([&](const Entry& e) {
    return e.declaration.recorded && e.origin != Origin::by_default && e.heading != without;
  });
}

std::string OptionSet::as_file() const {
  std::string text =
      fmt::format("# luxel {}: every option, its value, and where the value came from.\n", name_);
  std::string heading;
  for (const auto& e : entries_) {
    if (!e.declaration.configurable) continue;
    if (e.heading != heading) text += fmt::format("\n# {}\n", heading = e.heading);
    auto value = fmt::format("\"{}\"", e.declaration.print());
    if (e.declaration.many)
      value = fmt::format("[\"{}\"]", fmt::join(lines(e.declaration.print()), "\", \""));
    const bool is_empty = e.declaration.many && e.declaration.print().empty();
    text += fmt::format("{}{} = {}  # {}{}\n", is_empty ? "# " : "", e.declaration.name, value,
                        e.declaration.unit.empty() ? "" : e.declaration.unit + "; ", word(e.origin));
  }
  return text;
}

}  // namespace luxel
