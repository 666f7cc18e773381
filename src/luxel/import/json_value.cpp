// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/json_value.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/json.h"

namespace luxel {
namespace {

const SortedJson& json(const void* node) { return *static_cast<const SortedJson*>(node); }

// An excerpt of a value, long enough to recognise it.
std::string excerpt(const SortedJson& value) {
  constexpr std::size_t most = 40;
  if (value.is_object()) return "an object";
  if (value.is_array()) return fmt::format("an array of {}", value.size());
  auto text = value.dump(-1, ' ', true, SortedJson::error_handler_t::replace);
  if (text.size() > most) text = text.substr(0, most) + "...";
  return text;
}

}  // namespace

struct JsonValue::Document {
  SortedJson root;
  std::string source;
};

JsonValue::JsonValue(std::shared_ptr<const Document> document, const void* node, std::string path)
    : document_(std::move(document)), node_(node), path_(std::move(path)) {}

JsonValue JsonValue::parse(std::string_view text, std::string source) {
  try {
    const auto document =
        std::make_shared<const Document>(Document{SortedJson::parse(text.begin(), text.end()), source});
    return {document, &document->root, ""};
  } catch (const SortedJson::parse_error& error) {
    const auto before = text.substr(0, std::min(text.size(), error.byte));
    const auto line = 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
    const auto column = before.size() - std::min(before.rfind('\n') + 1, before.size());
    throw InputError(
        source, line,
        fmt::format("expected JSON, found something else at column {}; the file is damaged or of "
                    "another format",
                    column));
  } catch (const SortedJson::exception&) {  // a number such as 1e999
    throw InputError(source, "expected JSON with numbers below 1e308; the file is damaged");
  }
}

JsonValue JsonValue::at(const void* node, std::string path) const {
  return {document_, node, std::move(path)};
}

const std::string& JsonValue::source() const { return document_->source; }

void JsonValue::refuse(const std::string& message) const {
  throw InputError(source(), fmt::format("{}: {}", path_.empty() ? "/" : path_, message));
}

void JsonValue::refuse_kind(std::string_view expected) const {
  refuse(fmt::format("expected {}, found {}", expected, excerpt(json(node_))));
}

void JsonValue::expect_there(std::string_view expected) const {
  if (!node_) refuse(fmt::format("expected {}, found nothing", expected));
}

JsonValue JsonValue::operator[](std::string_view key) const {
  auto path = fmt::format("{}/{}", path_, key);
  if (!node_) return at(nullptr, std::move(path));
  const auto& value = json(node_);
  if (!value.is_object()) refuse_kind("an object");
  const auto found = value.find(key);
  return at(found == value.end() ? nullptr : &*found, std::move(path));
}

bool JsonValue::is_object() const { return node_ && json(node_).is_object(); }

bool JsonValue::is_text() const { return node_ && json(node_).is_string(); }

bool JsonValue::is_truth() const { return node_ && json(node_).is_boolean(); }

JsonValue JsonValue::operator[](std::size_t index) const {
  return at(&json(node_)[index], fmt::format("{}/{}", path_, index));
}

std::size_t JsonValue::size() const {
  if (!node_) return 0;
  if (!json(node_).is_array()) refuse_kind("an array");
  return json(node_).size();
}

std::vector<std::string> JsonValue::keys() const {
  std::vector<std::string> keys;
  if (!node_) return keys;
  if (!json(node_).is_object()) refuse_kind("an object");
  for (const auto& [key, value] : json(node_).items()) keys.push_back(key);
  return keys;
}

double JsonValue::number(double otherwise) const { return node_ ? number() : otherwise; }

double JsonValue::number() const {
  expect_there("a number");
  if (!json(node_).is_number()) refuse_kind("a number");
  return json(node_).get<double>();
}

std::size_t JsonValue::whole(std::size_t otherwise) const { return node_ ? whole() : otherwise; }

// Some programs write whole numbers as 3.0.
std::size_t JsonValue::whole() const {
  constexpr auto expected = "a whole number of 0 or more";
  constexpr double most = 1LL << 53;
  expect_there(expected);
  const auto& value = json(node_);
  if (value.is_number_unsigned()) return value.get<std::size_t>();
  const auto number = value.is_number_float() ? value.get<double>() : -1.0;
  if (!(number >= 0.0 && number <= most && number == std::floor(number))) refuse_kind(expected);
  return static_cast<std::size_t>(number);
}

bool JsonValue::truth(bool otherwise) const {
  if (!node_) return otherwise;
  if (!json(node_).is_boolean()) refuse_kind("true or false");
  return json(node_).get<bool>();
}

std::string JsonValue::text(const std::string& otherwise) const { return node_ ? text() : otherwise; }

std::string JsonValue::text() const {
  expect_there("a text");
  if (!json(node_).is_string()) refuse_kind("a text");
  return json(node_).get<std::string>();
}

std::vector<double> JsonValue::numbers(const std::vector<double>& otherwise) const {
  if (!node_) return otherwise;
  if (size() != otherwise.size())
    refuse(fmt::format("expected {} numbers, found {}", otherwise.size(), size()));
  std::vector<double> numbers;
  for (std::size_t i = 0; i < size(); ++i) numbers.push_back((*this)[i].number());
  return numbers;
}

}  // namespace luxel
