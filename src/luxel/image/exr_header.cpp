// SPDX-License-Identifier: Apache-2.0
#include "luxel/image/exr_header.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <optional>

#include "luxel/image/codec.h"

namespace luxel {
namespace {

struct FixedType {
  std::string_view name;
  std::size_t size;
};
constexpr FixedType fixed_types[] = {{"box2f", 16},
                                     {"box2i", 16},
                                     {"chromaticities", 32},
                                     {"compression", 1},
                                     {"deepImageState", 1},
                                     {"double", 8},
                                     {"envmap", 1},
                                     {"float", 4},
                                     {"int", 4},
                                     {"keycode", 28},
                                     {"lineOrder", 1},
                                     {"m33d", 72},
                                     {"m33f", 36},
                                     {"m44d", 128},
                                     {"m44f", 64},
                                     {"rational", 8},
                                     {"tiledesc", 9},
                                     {"timecode", 8},
                                     {"v2d", 16},
                                     {"v2f", 8},
                                     {"v2i", 8},
                                     {"v3d", 24},
                                     {"v3f", 12},
                                     {"v3i", 12}};

class Cursor {
 public:
  explicit Cursor(std::string_view rest) : rest_(rest) {}

  bool is_at_end() const { return rest_.empty(); }
  bool is_at_null() const { return !rest_.empty() && rest_.front() == '\0'; }
  std::size_t left() const { return rest_.size(); }
  // Nothing where the bytes end before it does.
  std::optional<std::string_view> text() {
    const auto end = rest_.find('\0');
    if (end == std::string_view::npos) return {};
    const auto text = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    return text;
  }
  std::optional<std::int32_t> integer() {
    std::int32_t value = 0;
    if (rest_.size() < sizeof(value)) return {};
    std::memcpy(&value, rest_.data(), sizeof(value));
    rest_.remove_prefix(sizeof(value));
    return value;
  }
  std::optional<std::string_view> bytes(std::int64_t count) {
    if (count < 0 || static_cast<std::uint64_t>(count) > rest_.size()) return {};
    const auto taken = rest_.substr(0, static_cast<std::size_t>(count));
    rest_.remove_prefix(static_cast<std::size_t>(count));
    return taken;
  }

 private:
  std::string_view rest_;
};

// Names, each with 16 bytes, and a null.
bool is_channel_list(Cursor value) {
  constexpr int size_of_channel = 16;
  while (!value.is_at_null())
    if (!value.text() || !value.bytes(size_of_channel)) return false;
  return value.left() == 1;
}

// Strings, each behind its length.
bool is_string_list(Cursor value) {
  while (!value.is_at_end()) {
    const auto size = value.integer();
    if (!size || !value.bytes(*size)) return false;
  }
  return true;
}

// Width, height, four bytes per pixel.
bool is_preview(Cursor value) {
  const auto width = value.integer(), height = value.integer();
  if (!width || !height || *width < 0 || *height < 0) return false;
  const auto pixels = std::int64_t{*width} * *height;
  return pixels <= static_cast<std::int64_t>(value.left()) &&
         4 * pixels == static_cast<std::int64_t>(value.left());
}

bool is_valid(std::string_view type, std::string_view value) {
  const auto* fixed = std::find_if(std::begin(fixed_types), std::end(fixed_types),
                                   [&](const FixedType& t) { return t.name == type; });
  if (fixed != std::end(fixed_types)) return value.size() == fixed->size;
  if (type == "chlist") return is_channel_list(Cursor(value));
  if (type == "stringvector") return is_string_list(Cursor(value));
  if (type == "preview") return is_preview(Cursor(value));
  if (type == "floatvector") return value.size() % sizeof(float) == 0;
  return true;
}

// OpenEXR makes buffers for whole rows before anyone can ask how long they are. bytes: of the file.
void check_window(std::string_view box, std::size_t bytes) {
  std::int32_t corner[4];  // lowest x and y, highest x and y
  std::memcpy(corner, box.data(), sizeof(corner));
  check_size(std::int64_t{corner[2]} - corner[0] + 1, std::int64_t{corner[3]} - corner[1] + 1, bytes);
}

}  // namespace

void check_exr_header(std::string_view bytes) {
  constexpr std::size_t begin = 8;  // after signature and version
  constexpr unsigned has_parts = 0x10;
  if (bytes.size() < begin) return;
  const bool is_list =
      (static_cast<unsigned char>(bytes[5]) & has_parts) != 0;  // of headers, the last one empty
  Cursor cursor(bytes.substr(begin));
  bool is_empty = true;
  while (!cursor.is_at_end()) {
    if (cursor.is_at_null()) {
      if (!is_list || is_empty) return;
      cursor.text();
      is_empty = true;
      continue;
    }
    is_empty = false;
    const auto name = cursor.text(), type = cursor.text();
    const auto size = cursor.integer();
    if (!name || !type || !size) return;
    const auto value = cursor.bytes(*size);
    if (!value) throw CodecError("an attribute of its header is larger than the file");
    if (!is_valid(*type, *value)) throw CodecError("an attribute of its header has a wrong length");
    if (*name == "dataWindow" && *type == "box2i") check_window(*value, bytes.size());
  }
}

}  // namespace luxel
