// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/ply_header.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/import/text.h"

namespace luxel {
namespace {

struct TypeName {
  std::string_view name;
  PlyType type;
};
constexpr auto type_names = std::to_array<TypeName>({{"char", PlyType::i8},
                                                     {"int8", PlyType::i8},
                                                     {"uchar", PlyType::u8},
                                                     {"uint8", PlyType::u8},
                                                     {"short", PlyType::i16},
                                                     {"int16", PlyType::i16},
                                                     {"ushort", PlyType::u16},
                                                     {"uint16", PlyType::u16},
                                                     {"int", PlyType::i32},
                                                     {"int32", PlyType::i32},
                                                     {"uint", PlyType::u32},
                                                     {"uint32", PlyType::u32},
                                                     {"float", PlyType::f32},
                                                     {"float32", PlyType::f32},
                                                     {"double", PlyType::f64},
                                                     {"float64", PlyType::f64}});

class HeaderReader {
 public:
  HeaderReader(std::string_view bytes, const std::string& source) : rest_(bytes), source_(source) {}

  PlyHeader read();

 private:
  [[noreturn]] void refuse(const std::string& message) const {
    throw InputError(source_, header_.lines, message);
  }
  void choose_line_end();
  std::string_view take_line();
  void take_format(std::string_view words);
  void take_element(std::string_view words);
  void take_property(std::string_view words);
  void take_comment(std::string_view words);
  PlyType type_of(std::string_view word) const;

  std::string_view rest_;
  const std::string& source_;
  std::string_view line_end_ = "\n";
  PlyHeader header_;
  bool has_format_ = false;
};

// The first line shows how lines end. Binary data may begin with any byte, so the last line of the header
// must end in the same way.
void HeaderReader::choose_line_end() {
  const auto end = rest_.find_first_of("\r\n");
  if (end == std::string_view::npos) return;
  line_end_ = rest_[end] == '\n' ? "\n" : rest_.substr(end, 2) == "\r\n" ? "\r\n" : "\r";
}

std::string_view HeaderReader::take_line() {
  ++header_.lines;
  const auto end = rest_.find(line_end_);
  if (end == std::string_view::npos) refuse("the header of this PLY has no end; expected 'end_header'");
  const auto line = rest_.substr(0, end);
  rest_.remove_prefix(end + line_end_.size());
  return trim(line);
}

void HeaderReader::take_format(std::string_view words) {
  const auto name = take_word(words), version = take_word(words);
  if (name == "ascii")
    header_.encoding = PlyEncoding::ascii;
  else if (name == "binary_little_endian")
    header_.encoding = PlyEncoding::little_endian;
  else if (name == "binary_big_endian")
    header_.encoding = PlyEncoding::big_endian;
  else
    refuse(fmt::format("expected the format ascii, binary_little_endian or binary_big_endian, found '{}'",
                       excerpt(name)));
  if (version != "1.0") refuse(fmt::format("expected version 1.0 of PLY, found '{}'", excerpt(version)));
  has_format_ = true;
}

void HeaderReader::take_element(std::string_view words) {
  PlyElement element;
  element.name = take_word(words);
  element.line = header_.lines;
  const auto count = take_word(words);
  const auto end = count.data() + count.size();
  const auto [stop, error] = std::from_chars(count.data(), end, element.count);
  if (element.name.empty() || error != std::errc() || stop != end)
    refuse(fmt::format("expected a name and a count after element, found '{} {}'", excerpt(element.name),
                       excerpt(count)));
  header_.elements.push_back(std::move(element));
}

PlyType HeaderReader::type_of(std::string_view word) const {
  const auto found = std::find_if(type_names.begin(), type_names.end(),
                                  [&](const TypeName& known) { return known.name == word; });
  if (found == type_names.end())
    refuse(fmt::format("expected a type such as float, uchar or int32, found '{}'", excerpt(word)));
  return found->type;
}

void HeaderReader::take_property(std::string_view words) {
  if (header_.elements.empty()) refuse("a property stands before the first element");
  PlyProperty property;
  auto type = take_word(words);
  property.is_list = type == "list";
  if (property.is_list) {
    property.count_type = type_of(take_word(words));
    if (!is_whole(property.count_type)) refuse("expected the count of a list to be of a whole type");
    type = take_word(words);
  }
  property.type = type_of(type);
  property.name = take_word(words);
  if (property.name.empty()) refuse("expected a name at the end of the property");
  header_.elements.back().properties.push_back(std::move(property));
}

void HeaderReader::take_comment(std::string_view words) {
  const auto keyword = take_word(words);
  if (lower_case(keyword) == "texturefile" && !words.empty()) header_.textures.emplace_back(words);
}

PlyHeader HeaderReader::read() {
  const auto all = rest_.size();
  choose_line_end();
  if (rest_.substr(0, 3) != "ply" || take_line() != "ply")
    throw InputError(source_, "expected a PLY file, whose first line is 'ply', found another one");
  for (;;) {
    auto words = take_line();
    const auto keyword = take_word(words);
    if (keyword == "end_header") break;
    if (keyword == "format")
      take_format(words);
    else if (keyword == "element")
      take_element(words);
    else if (keyword == "property")
      take_property(words);
    else if (keyword == "comment")
      take_comment(words);
    else if (!keyword.empty() && keyword != "obj_info")
      refuse(fmt::format("expected format, element, property, comment or end_header, found '{}'",
                         excerpt(keyword)));
  }
  if (!has_format_) refuse("the header of this PLY has no line 'format'");
  header_.size = all - rest_.size();
  return std::move(header_);
}

}  // namespace

std::size_t size_of(PlyType type) {
  constexpr std::array<std::size_t, 8> sizes = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

PlyHeader read_ply_header(std::string_view bytes, const std::string& source) {
  return HeaderReader(bytes, source).read();
}

}  // namespace luxel
