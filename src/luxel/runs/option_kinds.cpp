// SPDX-License-Identifier: Apache-2.0
// The common kinds of options.
#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "luxel/runs/option_set.h"
#include "luxel/runs/quantity.h"

namespace luxel {
namespace {

template <typename Number>
std::optional<Number> whole_number(const std::string& text) {
  Number value{};
  const auto* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end) return std::nullopt;
  return value;
}

template <typename Number>
Declaration bounded(const char* name, const char* unit, Number& value, Number min, Number max,
                    const char* help) {
  const auto parse = [=, &value](const std::string& text) {
    const auto number = whole_number<Number>(text);
    if (!number || !(*number >= min && *number <= max))
      throw UsageError(fmt::format("--{}: expected a number from {} to {}, not '{}'", name, min, max, text));
    value = *number;
  };
  return {name, unit, help, parse, [&value] { return fmt::format("{}", value); }};
}

// "1.5,0,-2", or nothing.
}  // namespace

std::optional<float> parse_number(const std::string& text) { return whole_number<float>(text); }
std::optional<double> parse_double(const std::string& text) { return whole_number<double>(text); }
std::optional<Vec3d> parse_three(const std::string& text) {
  Vec3d numbers;
  std::size_t begin = 0;
  for (int i = 0; i < 3; ++i) {
    const auto end = i < 2 ? text.find(',', begin) : text.size();
    const auto number =
        end == std::string::npos ? std::nullopt : whole_number<double>(text.substr(begin, end - begin));
    if (!number || !std::isfinite(*number)) return std::nullopt;
    numbers[i] = *number;
    begin = end + 1;
  }
  return numbers;
}

std::uint64_t parse_count(const std::string& name, const std::string& text) {
  auto digits = text;
  double factor = 1.0;
  if (!digits.empty()) {
    const auto suffix = std::string_view("kMG").find(digits.back());
    if (suffix != std::string_view::npos) {
      factor = std::pow(1000.0, static_cast<double>(suffix + 1));
      digits.pop_back();
    }
  }
  const auto number = whole_number<double>(digits);
  if (!number || !(*number >= 0.0) || *number * factor > 1e15)
    throw UsageError(fmt::format("--{}: expected a count such as 50M, 1.5G or 2000, not '{}'", name, text));
  return static_cast<std::uint64_t>(std::llround(*number * factor));
}

void OptionSet::add_number(const char* name, const char* unit, float& value, float min, float max,
                           const char* help) {
  add(bounded(name, unit, value, min, max, help));
}
void OptionSet::add_number(const char* name, const char* unit, double& value, double min, double max,
                           const char* help) {
  add(bounded(name, unit, value, min, max, help));
}
void OptionSet::add_number(const char* name, const char* unit, int& value, int min, int max,
                           const char* help) {
  add(bounded(name, unit, value, min, max, help));
}

void OptionSet::add_number(const char* name, const char* unit, std::uint32_t& value, std::uint32_t min,
                           std::uint32_t max, const char* help) {
  add(bounded(name, unit, value, min, max, help));
}

void OptionSet::add_count(const char* name, std::uint64_t& value, const char* help) {
  const auto parse = [=, &value](const std::string& text) { value = parse_count(name, text); };
  add({name, "count", help, parse, [&value] { return fmt::format("{}", value); }});
}

void OptionSet::add_fraction(const char* name, double& value, const char* help) {
  const auto parse = [=, &value](const std::string& text) {
    const auto fraction = parse_fraction(text);
    if (!fraction || !(*fraction > 0.0))
      throw UsageError(
          fmt::format("--{}: expected a fraction above 0 such as 2% or 0.02, not '{}'", name, text));
    value = *fraction;
  };
  add({name, "fraction", help, parse, [&value] { return as_fraction(value); }});
}

void OptionSet::add_text(const char* name, const char* unit, std::string& value, const char* help) {
  add({name, unit, help, [&value](const std::string& text) { value = text; }, [&value] { return value; }});
}

void OptionSet::add_output(const char* name, std::string& value, const char* help) {
  add_text(name, "FILE", value, help);
  entries_.back().declaration.is_output = true;
}

void OptionSet::add_texts(const char* name, const char* unit, std::vector<std::string>& values,
                          const char* help) {
  Declaration declaration{name, unit, help, [&values](const std::string& text) { values.push_back(text); },
                          [&values] { return fmt::format("{}", fmt::join(values, "\n")); }};
  declaration.many = true;
  add(std::move(declaration));
}

void OptionSet::add_point(const char* name, const char* unit, std::optional<Vec3d>& value, const char* help) {
  const auto print = [&value] {
    return value ? fmt::format("{},{},{}", value->x, value->y, value->z) : "auto";
  };
  const auto parse = [=, &value](const std::string& text) {
    if (text == "auto") return value.reset();
    const auto point = parse_three(text);
    if (!point)
      throw UsageError(fmt::format("--{}: expected three numbers such as 1.5,0,-2, not '{}'", name, text));
    value = *point;
  };
  add({name, unit, help, parse, print});
}

void OptionSet::add_choice(const char* name, std::vector<std::string> words, std::string& value,
                           const char* help) {
  const auto all = fmt::format("{}", fmt::join(words, "|"));
  const auto parse = [=, &value](const std::string& text) {
    if (std::find(words.begin(), words.end(), text) == words.end())
      throw UsageError(fmt::format("--{}: expected one of {}, not '{}'", name, all, text));
    value = text;
  };
  add({name, all, help, parse, [&value] { return value; }});
}

void OptionSet::add_switch(const char* name, bool& value, const char* help) {
  const auto parse = [=, &value](const std::string& text) {
    if (text != "on" && text != "off")
      throw UsageError(fmt::format("--{}: expected on or off, not '{}'", name, text));
    value = text == "on";
  };
  add({name, "on|off", help, parse, [&value] { return value ? "on" : "off"; }});
}

void OptionSet::add_flag(const char* name, bool& value, const char* help, bool configurable) {
  const auto parse = [=, &value](const std::string& text) {
    if (text != "true" && text != "false")
      throw UsageError(fmt::format("--{}: expected true or false, not '{}'", name, text));
    value = text == "true";
  };
  Declaration declaration{name, "", help, parse, [&value] { return value ? "true" : "false"; }};
  declaration.is_flag = true;
  declaration.configurable = configurable;
  add(std::move(declaration));
}

}  // namespace luxel
